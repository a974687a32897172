// SPDX-License-Identifier: BSD-3-Clause
// English words for walking: verbs, ways, paces and gaits.
#include <string>

#include "workflows/words/lexicon_internal.h"

namespace gaitwright::words {
namespace {

using M = Meaning;

}  // namespace

void AddEnglishWalking(Lexicon& x) {
  x.Add("fwd|fw|frwd|fwds|to forward|to front|to the forward", M::kDirection, "forward");
  x.Add("bwd|bkwd|bwds|bck|to backward|to backwards", M::kDirection, "backward");
  x.Add(
      "crawl|crawling|crouch-walk|crouch walk|crouch-walking|duck-walk|duck walk|walk crouched|walk crouching|creep "
      "low|"
      "walk low|go low and walk|crawl along|army crawl|low crawl|commando crawl|slither",
      M::kAction, "walk", 0.0, {{"height", std::string("low")}});
  x.Add("reached|arrived at|got to|made it to|gotten to|been to|approach|make for|go for", M::kAction, "walk", 1.0);
  x.Add("enter|enter with|exit|exit with", M::kAction, "walk");
  x.Add("run|running|ran", M::kAction, "walk", 0.0, {{"pace", std::string("fast")}});
  x.Add("sprint|sprinting|bolt|charge|charging|hustle|scram|step on it|full speed ahead", M::kAction, "walk", 0.0,
        {{"pace", std::string("fast")}});
  x.Add("slink|shimmy|scooch", M::kAction, "walk");
  x.Add("as quickly as you can|as quickly as possible|as fast as possible|as quick as you can|as quick as possible",
        M::kPace, "fast");
  x.Add("as slowly as you can|as slowly as possible|slow as you can|as slow as you can|as slow as possible", M::kPace,
        "slow");
  x.Add(
      "with your body close to the ground|close to the ground|close to the floor|low down|hunkered down|stooping low|"
      "bending low|crouching low|on bent legs|with bent legs|with your legs bent|half squatting|squatting low|"
      "keeping close to the ground|hugging the ground",
      M::kLow);
  x.Add(
      "saunter|sauntering|scuttle|trundle|toddle|mosey|strut|wend|waddle|prance|scamper|carry on|keep going|set off|"
      "take off|off you go|get moving|start walking|begin walking|walk along|walk over|walk across|walk "
      "through|"
      "go along|go over|go across|go on over|nip over|pop over|pop|nip|skedaddle|ease|edge|"
      "hop over|wander over|wander off|stroll over|head on over|make for|go for|trek|traipse|"
      "cover|do a walk|take yourself|take yourself over|bring yourself|move along|move yourself|budge|"
      "shift|shift yourself|shift your weight over|progress|navigate|locomote|travel over",
      M::kAction, "walk");
  x.Add(
      "walk in reverse|go in reverse|move in reverse|walk back up|go backward|go backwards|walk backwards|walk "
      "backward|"
      "move backwards|move backward|fall back|pull back|draw back|shuffle back|edge back|back it up|scoot backwards|"
      "scoot backward|backing away|inch back|ease back|withdraw|back out|roll back",
      M::kAction, "walk", 0.0, {{"direction", std::string("backward")}});
  const std::string forward = "forward", backward = "backward";
  x.Add(
      "walk|walks|walking|walked|go|goes|going|move|moving|head|heading|march|marching|stroll|strolling|advance|"
      "advancing|proceed|travel|stride|striding|get to|get over to|get yourself "
      "to|come|step|stepping|run|running|jog|shuffle|shuffling|continue|"
      "make your way|take a walk|go for a walk|keep walking|walk on|head over|head off|wander|amble|drive|"
      "hike|tiptoe|creep|approach|return",
      M::kAction, "walk");
  x.Add("walked|moved|gone|stepped|marched|make tracks|get going|scoot|scurry|plod|trudge|stagger|cross|inch",
        M::kAction, "walk");
  x.Add("rush|hurry over|hurry|dash|race|hasten|speed|zip", M::kAction, "walk", 0.0, {{"pace", std::string("fast")}});
  x.Add(
      "back up|backing up|back off|retreat|retreating|reverse|reversing|back away|backtrack|step back|stepping back|"
      "move back|walk back|go back|backpedal|scoot back|come back",
      M::kAction, "walk", 0.0, {{"direction", backward}});
  x.Add(
      "take|taking|make|do|perform|give|give us|give me|show me|show us|execute|use|using|make them|make each one|have",
      M::kFiller);
  x.Add("trot|trotting|trots", M::kAction, "walk", 0.0, {{"gait", std::string("trot")}});
  x.Add("bound|bounding", M::kAction, "walk", 0.0, {{"gait", std::string("bound")}});
  x.Add("pacing|pace forward|pace ahead", M::kAction, "walk", 0.0, {{"gait", std::string("pace")}});
  x.Add("with a trot|in a trot|at a trot|trot gait|with a trot gait|using a trot|trotting gait", M::kGait, "trot");
  x.Add("in a pace gait|pace gait|with a pace gait", M::kGait, "pace");
  x.Add("with a bound|in a bound gait|bound gait|bounding gait|with a bounding gait", M::kGait, "bound");
  x.Add("walking gait|walk gait|with a walking gait|in a walking gait", M::kGait, "walk");
  x.Add(
      "side step|side stepping|sidestep|sidestepping|side-step|side-stepping|strafe|strafing|sidle|sidling|step aside|"
      "move aside|stand aside|move over|budge over|shift over|scoot over|slide over",
      M::kAction, "walk", 0.0, {{"direction", std::string("sideways")}});
  x.Add("slide", M::kAction, "walk");
  x.Add("sideways|sidewards|laterally|aside|to the side|to one side|to a side|off to the side|off to one side",
        M::kSideways);
  x.Add("from side to side|side to side|make way|make room", M::kFiller);
  x.Add("forward|forwards|ahead|straight ahead|straight on|straight|onward|onwards|straight forward|to the front",
        M::kDirection, forward);
  x.Add("backward|backwards|back|rearward|rearwards|in reverse|to the rear|to the back", M::kDirection, backward);
  x.Add(
      "slow|slow down|slowing down|slowly|at a slow pace|gently|gingerly|carefully|cautiously|at a leisurely "
      "pace|leisurely|at a slow speed|"
      "nice and slow|nice and slowly|more slowly|unhurriedly|at a crawl|at a snail's pace|without rushing|take your "
      "time|no rush|taking your time|"
      "without hurrying|in no hurry|a bit slower|slower|very slowly|real slow|nice and easy|softly|steady as she goes",
      M::kPace, "slow");
  x.Add(
      "fast|speed up|quickly|quick|rapidly|briskly|swiftly|at a fast pace|hurriedly|at a brisk pace|speedily|at high "
      "speed|"
      "as fast as you can|hurry up|on the double|in a hurry|at the double|chop chop|pronto|like the wind|make it "
      "snappy|"
      "at top speed|double quick|fast as you can|a bit faster|at a run|at a good clip|at a jog|faster|at a fast "
      "speed|at full speed|double time",
      M::kPace, "fast");
  x.Add(
      "crouched|crouching|in a crouch|crouched down|bent over|stooped|stooping|keeping low|staying low|keep low|"
      "stay low|hunched|hunched over|with bent knees|with knees bent|with your knees bent|low to the ground|keeping "
      "your body low|keeping your head down|with your head down|bent low|in a low stance|"
      "with a low body|crouched low|half crouched|"
      "with your body low|down low",
      M::kLow);
}

}  // namespace gaitwright::words
