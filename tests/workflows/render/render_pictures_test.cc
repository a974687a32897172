// SPDX-License-Identifier: BSD-3-Clause
// Options of pictures that are refused before a browser is started.
#include "workflows/render/render_pictures.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

namespace gaitwright {
namespace {

/// The message with which a picture and a film with changed options are refused; both have the same checks.
std::string RefusedPicture(const std::function<void(PictureOptions&)>& change) {
  PictureOptions options;
  change(options);
  std::vector<std::string> messages;
  for (const bool film : {false, true}) {
    try {
      if (film) {
        (void)RenderFilm("<html/>", FilmFormat::kGif, options);
      } else {
        (void)RenderPng("<html/>", 0.0, options);
      }
      ADD_FAILURE() << "not refused";
      return "";
    } catch (const InvalidArgument& error) {
      messages.emplace_back(error.what());
    }
  }
  EXPECT_EQ(messages[0], messages[1]);
  return messages[0];
}

TEST(RenderPictures, NumbersOutOfTheirRangeAreRefusedWithIt) {
  EXPECT_EQ(RefusedPicture([](auto& o) { o.width_px = 63; }), "the width in pixels is 63; it must be from 64 to 7680");
  EXPECT_EQ(RefusedPicture([](auto& o) { o.height_px = 4321; }),
            "the height in pixels is 4321; it must be from 64 to 4320");
  EXPECT_EQ(RefusedPicture([](auto& o) { o.frames_per_s = 0.5; }),
            "the number of frames per second is 0.5; it must be from 1 to 120");
  EXPECT_EQ(RefusedPicture([](auto& o) { o.speed = 0.0; }), "the speed is 0; it must be from 0.01 to 100");
  const double none = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(RefusedPicture([&](auto& o) { o.speed = none; }), "");
  EXPECT_NE(RefusedPicture([&](auto& o) { o.from_s = none; }), "");
}

TEST(RenderPictures, NamesThatDoNotExistAreRefusedWithThoseThatDo) {
  const std::string view = RefusedPicture([](auto& o) { o.view = "below"; });
  EXPECT_EQ(view.find("there is no view 'below'"), 0U) << view;
  for (const std::string& name : ViewNames()) EXPECT_NE(view.find("'" + name + "'"), std::string::npos) << name;
  const std::string overlay = RefusedPicture([](auto& o) { o.hidden = {"zmp", "shadow"}; });
  EXPECT_EQ(overlay.find("there is no overlay 'shadow'"), 0U) << overlay;
  for (const std::string& name : OverlayNames()) EXPECT_NE(overlay.find("'" + name + "'"), std::string::npos) << name;
}

TEST(RenderPictures, ATimeRangeWithoutTimeIsRefused) {
  EXPECT_EQ(RefusedPicture([](auto& o) { o.from_s = o.to_s = 2.0; }), "the time range from 2 to 2 s is empty");
  EXPECT_NE(RefusedPicture([](auto& o) { o.from_s = 3.0, o.to_s = 1.0; }), "");
}

}  // namespace
}  // namespace gaitwright
