// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/words/pieces.h"

#include <cctype>
#include <cstdint>
#include <cstring>
#include <map>

namespace gaitwright::words {
namespace {

/// The code point at a byte and its length; a byte that is not UTF-8 counts as one code point.
struct Point {
  std::uint32_t code = 0;
  std::size_t length = 1;
};

Point PointAt(const std::string& text, std::size_t at) {
  const auto byte = [&](std::size_t i) { return static_cast<std::uint32_t>(static_cast<unsigned char>(text[i])); };
  const std::uint32_t lead = byte(at);
  const std::size_t length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : lead >= 0xC0 ? 2 : 1;
  if (length == 1 || at + length > text.size()) return {lead, 1};
  std::uint32_t code = lead & (0xFFU >> (length + 1));
  for (std::size_t i = 1; i < length; ++i) code = code << 6U | (byte(at + i) & 0x3FU);
  return {code, length};
}

/// Converts full-width ASCII and typographic quotes to plain ASCII.
std::uint32_t Usual(std::uint32_t code) {
  if (code >= 0xFF01 && code <= 0xFF5E) return code - 0xFF01 + 0x21;
  if (code == 0x2018 || code == 0x2019) return '\'';
  if (code == 0x3000) return ' ';
  return code;
}

bool IsLetter(std::uint32_t code) {
  return (code < 128 && std::isalpha(static_cast<int>(code)) != 0) || (code >= 0xC0 && code < 0x250);
}
bool IsDigit(std::uint32_t code) { return code >= '0' && code <= '9'; }
bool IsHan(std::uint32_t code) {
  return (code >= 0x3400 && code <= 0x9FFF) || (code >= 0xF900 && code <= 0xFAFF) ||
         (code >= 0x20000 && code <= 0x2FFFF);
}

/// Converts traditional characters of instructions to simplified ones.
const std::string& Simplified(const std::string& character) {
  static const std::map<std::string, std::string> table = {
      {"請", "请"}, {"後", "后"}, {"轉", "转"}, {"兩", "两"}, {"揮", "挥"}, {"動", "动"}, {"舉", "举"}, {"雙", "双"},
      {"時", "时"}, {"過", "过"}, {"來", "来"}, {"個", "个"}, {"點", "点"}, {"頭", "头"}, {"邊", "边"}, {"腳", "脚"},
      {"單", "单"}, {"獨", "独"}, {"續", "续"}, {"繼", "继"}, {"這", "这"}, {"裡", "里"}, {"裏", "里"}, {"邁", "迈"},
      {"進", "进"}, {"遠", "远"}, {"還", "还"}, {"壓", "压"}, {"彎", "弯"}, {"煩", "烦"}, {"謝", "谢"}, {"機", "机"},
      {"對", "对"}, {"錯", "错"}, {"說", "说"}, {"話", "话"}, {"應", "应"}, {"該", "该"}, {"臺", "台"}, {"階", "阶"},
      {"標", "标"}, {"記", "记"}, {"紅", "红"}, {"藍", "蓝"}, {"門", "门"}, {"樁", "桩"}, {"電", "电"}, {"級", "级"},
      {"塊", "块"}, {"顆", "颗"}, {"張", "张"}, {"臥", "卧"}, {"頂", "顶"}, {"鐘", "钟"}, {"體", "体"}, {"順", "顺"},
      {"針", "针"}, {"從", "从"}, {"會", "会"}, {"嗎", "吗"}, {"給", "给"}, {"為", "为"}, {"幫", "帮"}, {"們", "们"},
      {"開", "开"}, {"關", "关"}, {"讓", "让"}, {"聽", "听"}, {"見", "见"}, {"觀", "观"}, {"眾", "众"}, {"護", "护"},
      {"備", "备"}, {"準", "准"}, {"穩", "稳"}, {"維", "维"}, {"勢", "势"}, {"態", "态"}, {"靜", "静"}, {"檢", "检"},
      {"離", "离"}, {"運", "运"}, {"遞", "递"}, {"連", "连"}, {"輕", "轻"}, {"緩", "缓"}, {"緊", "紧"}, {"趕", "赶"},
      {"條", "条"}, {"隻", "只"}, {"處", "处"}, {"擺", "摆"}, {"搖", "摇"}, {"側", "侧"}, {"橫", "横"}, {"歸", "归"},
      {"戲", "戏"}, {"禮", "礼"}, {"鐵", "铁"}, {"億", "亿"}, {"萬", "万"}, {"斷", "断"}, {"將", "将"}, {"與", "与"},
      {"於", "于"}, {"數", "数"}, {"壞", "坏"}, {"補", "补"}, {"誤", "误"}, {"換", "换"}, {"複", "复"}, {"復", "复"},
      {"幾", "几"}, {"雖", "虽"}, {"東", "东"}, {"寶", "宝"}, {"貝", "贝"}, {"貓", "猫"}, {"鳴", "鸣"}, {"獅", "狮"},
      {"腦", "脑"}, {"場", "场"}, {"圍", "围"}, {"圓", "圆"}, {"園", "园"}, {"彈", "弹"}, {"戰", "战"}, {"撲", "扑"},
      {"掃", "扫"}, {"掛", "挂"}, {"採", "采"}, {"據", "据"}, {"擊", "击"}, {"擋", "挡"}, {"擔", "担"}, {"擴", "扩"},
      {"攜", "携"}, {"曬", "晒"}, {"極", "极"}, {"樣", "样"}, {"樹", "树"}, {"橋", "桥"}, {"權", "权"}, {"歡", "欢"},
      {"歲", "岁"}, {"沒", "没"}, {"減", "减"}, {"滾", "滚"}, {"滿", "满"}, {"濕", "湿"}, {"無", "无"}, {"爲", "为"},
      {"爺", "爷"}, {"獲", "获"}, {"現", "现"}, {"環", "环"}, {"產", "产"}, {"畫", "画"}, {"異", "异"}, {"發", "发"},
      {"盤", "盘"}, {"確", "确"}, {"礎", "础"}, {"種", "种"}, {"稱", "称"}, {"筆", "笔"}, {"簡", "简"}, {"線", "线"},
      {"緒", "绪"}, {"練", "练"}, {"總", "总"}, {"績", "绩"}, {"織", "织"}, {"纔", "才"}, {"聲", "声"}, {"肅", "肃"},
      {"膽", "胆"}, {"臉", "脸"}, {"舊", "旧"}, {"艙", "舱"}, {"蓋", "盖"}, {"虧", "亏"}, {"號", "号"}, {"術", "术"},
      {"衝", "冲"}, {"裝", "装"}, {"視", "视"}, {"親", "亲"}, {"覺", "觉"}, {"覽", "览"}, {"規", "规"}, {"訊", "讯"},
      {"討", "讨"}, {"訓", "训"}, {"設", "设"}, {"許", "许"}, {"訴", "诉"}, {"評", "评"}, {"詞", "词"}, {"試", "试"},
      {"詳", "详"}, {"誠", "诚"}, {"誰", "谁"}, {"調", "调"}, {"談", "谈"}, {"論", "论"}, {"諾", "诺"}, {"謹", "谨"},
      {"識", "识"}, {"譯", "译"}, {"議", "议"}, {"讀", "读"}, {"變", "变"}, {"貨", "货"}, {"貼", "贴"}, {"費", "费"},
      {"賓", "宾"}, {"賽", "赛"}, {"跡", "迹"}, {"踐", "践"}, {"躍", "跃"}, {"車", "车"}, {"軌", "轨"}, {"輛", "辆"},
      {"輩", "辈"}, {"輸", "输"}, {"辦", "办"}, {"農", "农"}, {"遊", "游"}, {"達", "达"}, {"違", "违"}, {"適", "适"},
      {"選", "选"}, {"郵", "邮"}, {"鄉", "乡"}, {"醫", "医"}, {"鍵", "键"}, {"鎖", "锁"}, {"長", "长"}, {"閃", "闪"},
      {"閉", "闭"}, {"間", "间"}, {"閱", "阅"}, {"隊", "队"}, {"際", "际"}, {"隨", "随"}, {"險", "险"}, {"難", "难"},
      {"雞", "鸡"}, {"靈", "灵"}, {"響", "响"}, {"項", "项"}, {"預", "预"}, {"領", "领"}, {"題", "题"}, {"類", "类"},
      {"風", "风"}, {"飛", "飞"}, {"飯", "饭"}, {"館", "馆"}, {"馬", "马"}, {"駐", "驻"}, {"驗", "验"}, {"驚", "惊"},
      {"髮", "发"}, {"鬆", "松"}, {"魚", "鱼"}, {"鳥", "鸟"}, {"黃", "黄"}, {"齊", "齐"}, {"龍", "龙"}, {"賴", "赖"},
      {"並", "并"}, {"併", "并"}, {"測", "测"}, {"餘", "余"}, {"馀", "余"}, {"寫", "写"}, {"綫", "线"}, {"別", "别"},
      {"麼", "么"}, {"經", "经"}, {"嘗", "尝"}, {"帶", "带"}, {"著", "着"}, {"撐", "撑"}, {"託", "托"}, {"擠", "挤"},
      {"搶", "抢"}, {"攏", "拢"}, {"攔", "拦"}, {"學", "学"}, {"師", "师"}, {"廳", "厅"}, {"牆", "墙"}, {"慢", "慢"},
      {"屆", "届"}, {"幹", "干"}, {"噹", "当"}, {"當", "当"}, {"業", "业"}, {"務", "务"}, {"鏡", "镜"}, {"燈", "灯"},
      {"嗚", "呜"}, {"劇", "剧"}, {"檯", "台"}, {"顧", "顾"}, {"顏", "颜"}, {"絲", "丝"}, {"細", "细"}};
  const auto found = table.find(character);
  return found == table.end() ? character : found->second;
}

class PieceReader {
 public:
  explicit PieceReader(const std::string& text) : text_(text) {}

  std::vector<Piece> Read() {
    while (at_ < text_.size()) {
      const std::uint32_t code = Code(at_);
      if (code <= ' ' || code == 0xA0 || code == 0xFEFF) {
        at_ += PointAt(text_, at_).length;
      } else if (IsLetter(code)) {
        ReadWord();
      } else if (IsDigit(code)) {
        ReadNumber();
      } else {
        Begin(IsHan(code) ? Piece::Kind::kCharacter : Piece::Kind::kSign);
        Take();
      }
    }
    return std::move(pieces_);
  }

 private:
  std::uint32_t Code(std::size_t at) const { return at < text_.size() ? Usual(PointAt(text_, at).code) : 0; }
  std::uint32_t NextCode() const { return Code(at_ + PointAt(text_, at_).length); }

  void Begin(Piece::Kind kind) { pieces_.push_back({kind, "", at_, at_}); }

  void Take() {
    const Point point = PointAt(text_, at_);
    const std::uint32_t usual = Usual(point.code);
    Piece& piece = pieces_.back();
    if (usual < 128) {
      piece.text += static_cast<char>(std::tolower(static_cast<int>(usual)));
    } else {
      piece.text += Simplified(text_.substr(at_, point.length));
    }
    at_ += point.length;
    piece.end = at_;
  }

  void ReadWord() {
    Begin(Piece::Kind::kWord);
    while (at_ < text_.size()) {
      const std::uint32_t code = Code(at_);
      const bool joins = (code == '\'' || (code == '-' && !EndsNumber()) || code == '/') && IsLetter(NextCode());
      if (!IsLetter(code) && !joins) break;
      Take();
    }
    pieces_.back().text = Spelt(pieces_.back().text);
  }

  /// Expands common short forms.
  static std::string Spelt(const std::string& word) {
    static const std::map<std::string, std::string> table = {
        {"youre", "you're"}, {"youve", "you've"},   {"youll", "you'll"},  {"theres", "there's"},
        {"dont", "don't"},   {"thats", "that's"},   {"lets", "let's"},    {"im", "i'm"},
        {"ive", "i've"},     {"theyre", "they're"}, {"cant", "can't"},    {"wont", "won't"},
        {"hes", "he's"},     {"isnt", "isn't"},     {"whats", "what's"},  {"ur", "your"},
        {"u", "you"},        {"yr", "your"},        {"gimme", "give me"}, {"lemme", "let me"},
        {"pls", "please"},   {"plz", "please"},     {"y'all", "you"},     {"yall", "you"},
        {"ya", "you"},       {"wanna", "want to"},  {"d'you", "do you"},  {"everyones", "everyone's"}};
    const auto found = table.find(word);
    return found == table.end() ? word : found->second;
  }

  /// "two-metre": a number and its unit.
  bool EndsNumber() const {
    if (text_.compare(at_ + 1, 7, "quarter") == 0) return false;  // "three-quarter"
    static const char* const kNumbers[] = {"one",     "two",    "three",  "four",  "five",   "six",
                                           "seven",   "eight",  "nine",   "ten",   "eleven", "twelve",
                                           "fifteen", "twenty", "thirty", "forty", "fifty",  "sixty",
                                           "seventy", "eighty", "ninety", "half",  "quarter"};
    static const char* const kOnes[] = {"one", "two", "three", "four", "five", "six", "seven", "eight", "nine"};
    for (const char* one : kOnes) {
      if (pieces_.back().text.ends_with("ty") && text_.compare(at_ + 1, std::strlen(one), one) == 0) return false;
    }
    for (const char* number : kNumbers) {
      if (pieces_.back().text == number) return true;
    }
    return false;
  }

  void ReadNumber() {
    Begin(Piece::Kind::kNumber);
    bool point = false;
    while (at_ < text_.size()) {
      const std::uint32_t code = Code(at_);
      const bool joins = code == '.' && !point && IsDigit(NextCode());
      if (!IsDigit(code) && !joins) break;
      point = point || joins;
      Take();
    }
    TakeExponent();
    // "2nd", "10th" are words.
    static const char* const kEnds[] = {"st", "nd", "rd", "th"};
    for (const char* end : kEnds) {
      if (Code(at_) != static_cast<std::uint32_t>(end[0]) || Code(at_ + 1) != static_cast<std::uint32_t>(end[1]) ||
          IsLetter(Code(at_ + 2)))
        continue;
      pieces_.back().kind = Piece::Kind::kWord;
      Take();
      Take();
      return;
    }
  }

  /// "1.5e3", "2E-1".
  void TakeExponent() {
    if (Code(at_) != 'e' && Code(at_) != 'E') return;
    const bool sign = Code(at_ + 1) == '+' || Code(at_ + 1) == '-';
    if (!IsDigit(Code(at_ + (sign ? 2 : 1)))) return;
    Take();
    if (sign) Take();
    while (IsDigit(Code(at_))) Take();
  }

  const std::string& text_;
  std::size_t at_ = 0;
  std::vector<Piece> pieces_;
};

}  // namespace

std::vector<Piece> PiecesOf(const std::string& text) { return PieceReader(text).Read(); }

std::string PhraseOf(const std::vector<Piece>& pieces, std::size_t first, std::size_t count) {
  std::string phrase;
  for (std::size_t k = first; k < first + count; ++k) {
    const bool parted = k > first && pieces[k].kind != Piece::Kind::kCharacter &&
                        pieces[k - 1].kind != Piece::Kind::kCharacter && pieces[k].begin > pieces[k - 1].end;
    if (parted) phrase += ' ';
    phrase += pieces[k].text;
  }
  return phrase;
}

}  // namespace gaitwright::words
