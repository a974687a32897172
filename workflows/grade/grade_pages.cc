// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "playback/report/page_style.h"
#include "playback/report/svg_tools.h"
#include "workflows/grade/grade.h"

namespace gaitwright {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kLongestShownName = 60;

/// A cell in quotes; a text that a spreadsheet would read as a formula begins with an apostrophe.
std::string Cell(const std::string& text) {
  std::string cell;
  for (const char c : text) cell += c == '"' ? "\"\"" : std::string(1, c);
  const bool formula = !text.empty() && std::string("=+-@\t\r").find(text.front()) != std::string::npos;
  return fmt::format("\"{}{}\"", formula ? "'" : "", cell);
}

std::string Page(const std::string& title, const std::string& body) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"/>"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src 'unsafe-inline'\"/>"
      "<meta name=\"viewport\" content=\"width=device-width\"/><title>{0}</title><style>{1}</style></head>\n"
      "<body><main>\n<h1>{0}</h1>\n{2}</main></body></html>\n",
      EscapedXml(title), PageStyle(), body);
}

std::string Points(double points, double of) { return fmt::format("{} of {}", PointsText(points), PointsText(of)); }

std::string Warning(const ClassMarks& marks) {
  if (marks.confined) return "";
  return "<p class=\"reason fail\">Submissions were run unconfined, so they had access to other files on this machine. "
         "Trust the marks of code only as far as you trust the students.</p>\n";
}

std::string MotionName(const std::string& page, std::size_t part, std::size_t motion) {
  return fmt::format("{}-{}-{}.html", page.substr(0, page.size() - 5), part + 1, motion + 1);
}

std::string ChecksTable(const PartMark& part) {
  std::string html = "<table><tr><th>measure</th><th>value</th><th>points</th></tr>\n";
  for (const CheckMark& check : part.checks) {
    html += fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td></tr>\n", EscapedXml(check.measure),
                        check.value ? fmt::format("{:.4g}", *check.value) : "none", Points(check.points, check.of));
  }
  return html + "</table>\n";
}

std::string PartSection(const PartMark& part, const std::string& page, std::size_t number) {
  std::string html =
      fmt::format("<h2>{}: {}</h2>\n{}", EscapedXml(part.title), Points(part.points, part.of), ChecksTable(part));
  if (!part.reasons.empty()) html += "<p>Lost points and reasons:</p>\n<ul>\n";
  for (const std::string& reason : part.reasons) html += fmt::format("<li>{}</li>\n", EscapedXml(reason));
  if (!part.reasons.empty()) html += "</ul>\n";
  for (std::size_t i = 0; i < part.pages.size(); ++i)
    html += fmt::format("<p><a href=\"{}\">{}</a></p>\n", MotionName(page, number, i), EscapedXml(part.pages[i].title));
  return html;
}

}  // namespace

std::string PageNameOf(const std::string& student, std::size_t number) {
  std::string name = fmt::format("{:03}-", number + 1);
  for (const char c : student.substr(0, kLongestShownName)) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    name += plain ? c : '_';
  }
  return name + ".html";
}

std::vector<OutputFile> StudentPages(const ClassMarks& marks, const StudentMarks& student, std::size_t number) {
  const std::string page = PageNameOf(student.student, number);
  std::string body = fmt::format("<p>{}; seed {}</p>\n<p><b>{}</b> points</p>\n", EscapedXml(marks.title), marks.seed,
                                 Points(student.points(), student.of())) +
                     Warning(marks);
  std::vector<OutputFile> files;
  for (std::size_t part = 0; part < student.parts.size(); ++part) {
    body += PartSection(student.parts[part], page, part);
    for (std::size_t i = 0; i < student.parts[part].pages.size(); ++i)
      files.push_back({MotionName(page, part, i), student.parts[part].pages[i].html});
  }
  body += "<p><a href=\"index.html\">All students</a></p>\n";
  files.insert(files.begin(), {page, Page(student.student, body)});
  return files;
}

std::string ClassPage(const ClassMarks& marks) {
  std::string body = fmt::format("<p>{} submissions; {} points; seed {}</p>\n", marks.students.size(),
                                 PointsText(marks.of), marks.seed) +
                     Warning(marks) + "<table><tr><th>student</th>";
  for (const std::string& part : marks.parts) body += fmt::format("<th>{}</th>", EscapedXml(part));
  body += "<th>total</th></tr>\n";
  for (std::size_t i = 0; i < marks.students.size(); ++i) {
    const StudentMarks& student = marks.students[i];
    body +=
        fmt::format("<tr><td><a href=\"{}\">{}</a></td>", PageNameOf(student.student, i), EscapedXml(student.student));
    for (const PartMark& part : student.parts) body += fmt::format("<td>{}</td>", Points(part.points, part.of));
    body += fmt::format("<td><b>{}</b></td></tr>\n", PointsText(student.points()));
  }
  return Page(marks.title, body + "</table>\n");
}

std::string GradesCsv(const ClassMarks& marks) {
  std::string csv = "\"student\"";
  for (const std::string& part : marks.parts) csv += "," + Cell(part);
  csv += ",\"total\",\"of\"\n";
  for (const StudentMarks& student : marks.students) {
    csv += Cell(student.student);
    for (const PartMark& part : student.parts) csv += "," + PointsText(part.points);
    csv += fmt::format(",{},{}\n", PointsText(student.points()), PointsText(student.of()));
  }
  return csv;
}

std::string GradesJson(const ClassMarks& marks) {
  Json students = Json::array();
  for (std::size_t i = 0; i < marks.students.size(); ++i) {
    const StudentMarks& student = marks.students[i];
    Json parts = Json::array();
    for (const PartMark& part : student.parts) {
      Json checks = Json::array();
      for (const CheckMark& check : part.checks)
        checks.push_back({{"measure", check.measure},
                          {"value", check.value ? Json(*check.value) : Json()},
                          {"points", check.points},
                          {"of", check.of}});
      parts.push_back({{"part", part.part},
                       {"points", part.points},
                       {"of", part.of},
                       {"checks", checks},
                       {"reasons", part.reasons}});
    }
    students.push_back({{"student", student.student},
                        {"points", student.points()},
                        {"of", student.of()},
                        {"page", PageNameOf(student.student, i)},
                        {"parts", parts}});
  }
  const Json json = {{"title", marks.title},
                     {"seed", marks.seed},
                     {"confined", marks.confined},
                     {"of", marks.of},
                     {"students", students}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

}  // namespace gaitwright
