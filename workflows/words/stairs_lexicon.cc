// SPDX-License-Identifier: BSD-3-Clause
// Words for stairs and for going up and down them, in both languages.
#include <string>

#include "workflows/words/lexicon_internal.h"

namespace gaitwright::words {
namespace {

using M = Meaning;

}  // namespace

void AddEnglishStairs(Lexicon& x) {
  x.Add("stairs|staircase|stairway|flight of stairs|a flight of stairs|flight of steps|a flight of steps|the steps",
        M::kStairs);
  x.Add("upstairs", M::kStairs, "", 1.0);
  x.Add("downstairs", M::kStairs, "", -1.0);
  x.Add("climb|climbing|climbed|climb up|climbing up|ascend|ascending|mount|clamber up|take the stairs|use the stairs",
        M::kAction, "walk", kUpStairs);
  x.Add("climb down|climbing down|climb back down|descend|descending|clamber down", M::kAction, "walk", kDownStairs);
  x.Add("go up|going up|gone up|walk up|walking up|walked up|step up|head up|come up|go on up|make your way up",
        M::kAction, "walk", kUpwards);
  x.Add(
      "go down|going down|gone down|walk down|walking down|walked down|step down|head down|come down|go on down|"
      "go back down|walk back down|come back down|make your way down",
      M::kAction, "walk", kDownwards);
  x.Add("run up", M::kAction, "walk", kUpwards, {{"pace", std::string("fast")}});
  x.Add("run down", M::kAction, "walk", kDownwards, {{"pace", std::string("fast")}});
  x.Add("up|upward|upwards", M::kUp, "way");
  x.Add("down|downward|downwards|back down|down again", M::kDown, "way");
}

void AddChineseStairs(Lexicon& x) {
  x.Add("级|阶|节", M::kFiller, "级");
  x.Add("楼梯|阶梯", M::kStairs);
  x.Add(
      "爬|攀|攀登|登|上楼|上楼去|上楼梯|上楼梯去|上台阶|上阶梯|走上楼|走上楼去|走上楼梯|走上台阶|爬楼|爬楼梯|爬上楼|"
      "爬上楼去|"
      "爬上楼梯|爬上台阶|爬台阶|爬阶梯|登楼|登上楼梯|登楼梯|登台阶|登上台阶",
      M::kAction, "walk", kUpStairs);
  x.Add("下楼|下楼去|下楼梯|下楼梯去|下台阶|下阶梯|走下楼|走下楼去|走下楼梯|走下台阶|爬下|爬下楼梯|爬下台阶",
        M::kAction, "walk", kDownStairs);
  x.Add("走上|爬上|登上|踏上|跨上|迈上|走上去|往上走|向上走|往上爬|向上爬|爬上去", M::kAction, "walk", kUpwards);
  x.Add("走下去|往下走|向下走", M::kAction, "walk", kDownwards);
  x.Add("跑上去", M::kAction, "walk", kUpwards, {{"pace", std::string("fast")}});
  x.Add("跑上楼|跑上楼梯|跑上台阶", M::kAction, "walk", kUpStairs, {{"pace", std::string("fast")}});
  x.Add("跑下楼|跑下楼梯|跑下台阶", M::kAction, "walk", kDownStairs, {{"pace", std::string("fast")}});
  x.Add("上去|往上|向上", M::kUp, "way");
}

}  // namespace gaitwright::words
