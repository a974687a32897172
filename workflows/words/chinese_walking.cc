// SPDX-License-Identifier: BSD-3-Clause
// Chinese words for walking: verbs, ways, paces and gaits.
#include <string>

#include "workflows/words/lexicon_internal.h"

namespace gaitwright::words {
namespace {

using M = Meaning;

}  // namespace

void AddChineseWalking(Lexicon& x) {
  const std::string forward = "forward", backward = "backward", left = "left", right = "right";
  x.Add("走过", M::kUnknown);
  x.Add("斜着|斜着走|斜走|斜向|斜|左前方|右前方|左后方|右后方", M::kUnknown);
  x.Add(
      "横移|横着走|侧移|侧步|侧着走|侧走|侧行|横行|横挪|横跨|侧跨|侧滑|横步|平移|让开|让一让|让开点|让开一点|闪开|躲开|"
      "靠边|"
      "靠边站|往边上走|让让",
      M::kAction, "walk", 0.0, {{"direction", std::string("sideways")}});
  x.Add("横着|横向|侧向|侧着|横|侧身|侧着身子|侧过身", M::kSideways);
  x.Add("快走|疾走|快跑|飞奔|疾跑|疾行|快步走|快跑过去|飞跑", M::kAction, "walk", 0.0, {{"pace", std::string("fast")}});
  x.Add("慢走|缓行|慢行|慢步走|缓步走", M::kAction, "walk", 0.0, {{"pace", std::string("slow")}});
  x.Add("直奔", M::kAction, "walk", 1.0, {{"pace", std::string("fast")}});
  x.Add("跑|跑着去|跑过去|跑起来|跑步", M::kAction, "walk", 0.0, {{"pace", std::string("fast")}});
  x.Add("跑到|跑去|跑向|奔向|跑去到|跑回|跑回到", M::kAction, "walk", 1.0, {{"pace", std::string("fast")}});
  x.Add("跑步前进|跑步向前|跑步走|冲刺|冲|往前冲|向前冲|往前冲刺|向前冲刺|快跑前进", M::kAction, "walk", 0.0,
        {{"direction", forward}, {"pace", std::string("fast")}});
  x.Add("齐步走|正步走|齐步前进|正步前进", M::kAction, "walk", 0.0, {{"direction", forward}});
  x.Add("匍匐前进|低姿匍匐前进|匍匐前行|爬行前进|爬行|匍匐", M::kAction, "walk", 0.0, {{"height", std::string("low")}});
  x.Add("低姿匍匐|匍匐着|爬着", M::kLow);
  x.Add("行前|行前面", M::kAction, "walk", 0.0, {{"direction", forward}});
  x.Add("行后|行返后", M::kAction, "walk", 0.0, {{"direction", backward}});
  x.Add("行去|行到|行过去|行埋去|走去到", M::kAction, "walk", 1.0);
  x.Add("行多|多走|再多走|多行|走多", M::kAction, "walk");
  x.Add(
      "退回来|走回来|退回到原位|原路退回|原路退回来|再退回来|退回原位|退回原处|走回原位|走回原处|回到原位|回到原处|"
      "走回去|退回去",
      M::kAction, "walk", 3.0, {{"direction", backward}});
  x.Add("原地踏步|原地走|原地跑|原地小跑|原地走路", M::kElsewhere, "walk");
  x.Add(
      "倒退着走|后退着走|倒着往后走|往后倒着走|向后倒着走|退着往后走|往后面走|向后面走|往后头走|后退走|倒退走|向后倒退|"
      "往后倒退|往后撤|向后撤|退着|倒走回",
      M::kAction, "walk", 0.0, {{"direction", std::string("backward")}});
  x.Add(
      "往前走|向前走|朝前走去|往前头走|向前行走|往前行走|向前行进|向前迈|往前迈|往前移动|向前移动|往前挪|向前挪|"
      "往前直走|向前直走|一直走|径直往前走",
      M::kAction, "walk", 0.0, {{"direction", std::string("forward")}});
  x.Add(
      "溜达|溜|踱|踱步|溜达到|晃到|跑过去|赶过去|赶|挪过去|移过去|靠过去|跨步|踏步|漫步|迈开步子|走个|走它|走出个|"
      "走上个|往那走|迈过去|直行|直着走|"
      "走走看|走一段|走一趟|行|走了|移步|挪步|挪个|移个",
      M::kAction, "walk");
  x.Add(
      "溜达到|晃到|跑去|赶去|走去到|去一下|过去到|移步到|移步至|挪步到|直接到|站到|站在|站上|停到|停在|"
      "回去到|跑回|跑回到|赶回|赶回到|前往到|前去|靠到|走近",
      M::kAction, "walk", 1.0);
  // A value of 1: a place follows.
  x.Add(
      "走|行走|走动|步行|走路|走走|散步|移动|移|挪|挪动|去|走过去|过去|走去|走一走|迈|迈步|跨|踏|迈出|跨出|"
      "踏出|"
      "跑|行进|走起来",
      M::kAction, "walk");
  x.Add("回|返回|回去|直走|径直走|朝前走|走着|接着走|继续走|走出|走出去|倒走着", M::kAction, "walk");
  x.Add(
      "走到|去到|来到|到达|走向|移到|移动到|挪到|跑到|回到|走回到|走至|赶到|跑向|奔向|回到了|走进|靠近|接近|"
      "移动至|挪至|前往到|爬到|走上到|跑去|上到|前往|走去",
      M::kAction, "walk", 1.0);
  x.Add("前进|向前进|往前进", M::kAction, "walk", 0.0, {{"direction", forward}});
  x.Add(
      "后退|倒退|倒回去|退后走|退回|退回去|往回走|往回退|向后走|往后走|朝后走|倒着退|后退着走|退着走|退|退后|向后退|"
      "往后退|倒着走|倒走|后撤|往后倒|倒车",
      M::kAction, "walk", 0.0, {{"direction", backward}});
  x.Add("小跑|慢跑|小步跑|快跑小步", M::kAction, "walk", 0.0, {{"gait", std::string("trot")}});
  x.Add("到|往|朝|向|奔|去往|到了", M::kTo);
  x.Add("trot|trot步态|对角步态|小跑步态|对角小跑", M::kGait, "trot");
  x.Add("bound|bound步态|跳跃步态|奔跃步态", M::kGait, "bound");
  x.Add("pace|pace步态|溜蹄|溜蹄步态|同侧步态|遛蹄", M::kGait, "pace");
  x.Add("walk|walk步态|行走步态|慢步步态", M::kGait, "walk");
  x.Add("向前|往前|朝前|前面|往前面|向前面|前方|向前方|直着|一直往前|一直向前|笔直|照直|往前方", M::kDirection,
        forward);
  x.Add("向后|往后|朝后|后面|往后面|向后面|倒着|后方|向后方|往回", M::kDirection, backward);
  x.Add(
      "向左|往左|朝左|左边|往左边|向左边|左侧|向左侧|往左侧|靠左|左面|左手边|朝左边|左方|向左手边|逆时针|逆时针方向|"
      "按逆时针",
      M::kSide, left);
  x.Add(
      "向右|往右|朝右|右边|往右边|向右边|右侧|向右侧|往右侧|靠右|右面|右手边|朝右边|右方|向右手边|顺时针|顺时针方向|"
      "按顺时针",
      M::kSide, right);
  x.Add(
      "慢慢|慢慢地|慢慢儿|慢|慢点|慢一点|慢些|缓慢|缓缓|缓慢地|缓缓地|慢速|小心|小心地|轻轻地|悠着点|不慌不忙地|"
      "慢悠悠地|慢吞吞地|慢步|慢慢悠悠地|不用急|不急|不着急|稳稳当当地|放慢速度|放慢|小心翼翼地|慢腾腾地|从容地|悠闲地|"
      "慢一些|缓步|轻手轻脚地|不要着急",
      M::kPace, "slow");
  x.Add(
      "快快快|跑快点|快快|快|快点|快一点|快些|快速|快速地|迅速|迅速地|赶快|赶紧|快快|飞快地|快步|大步|加快速度|"
      "用最快的速度|尽快|快点儿|"
      "快快地|急忙|匆匆|火速|全速|飞快|加快|加快步伐|加快脚步|跑着|一溜烟|大步流星|大踏步|大步地|马上|立刻|用最快速度|"
      "尽快地|急匆匆地|急步|疾步",
      M::kPace, "fast");
  x.Add(
      "弯着腰|蹲着|压低身子|压低身体|猫着腰|低着身子|弯腰|猫腰|压低重心|放低身子|放低身体|俯着身子|矮着身子|低姿|"
      "低姿态|降低重心|"
      "屈膝|屈着膝|曲着腿|弯着腿|弯着膝盖|俯身|伏低|压低|低着身体|半蹲着|弓着腰|弓着身子|弓腰|哈着腰|矮身|把身子压低|"
      "把身体压低|把身体放低|把身子放低|降低身体|重心放低|重心压低|伏着身子|伏着身体|低着腰|身体压低|身子压低|放低重心|"
      "低姿势",
      M::kLow);
}

}  // namespace gaitwright::words
