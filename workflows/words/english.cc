// SPDX-License-Identifier: BSD-3-Clause
#include <numbers>

#include "workflows/words/lexicon.h"

namespace gaitwright::words {
namespace {

using M = Meaning;

void AddWalking(Lexicon& x) {
  const std::string forward = "forward", backward = "backward";
  x.Add(
      "walk|walks|walking|walked|go|goes|going|move|moving|head|heading|march|marching|stroll|strolling|advance|"
      "advancing|proceed|travel|stride|striding|get to|get over to|get yourself "
      "to|come|step|stepping|run|running|jog|shuffle|shuffling|continue|"
      "make your way|make way|take a walk|go for a walk|keep walking|walk on|head over|head off|wander|amble|drive|"
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
      "side step|side stepping|sidestep|sidestepping|side-step|side-stepping|strafe|strafing|walk sideways|"
      "move sideways|go sideways|step sideways|shuffle sideways|slide",
      M::kAction, "walk");
  x.Add("sideways|sidewards|laterally", M::kFiller);
  x.Add("forward|forwards|ahead|straight ahead|straight on|straight|onward|onwards|straight forward|to the front",
        M::kDirection, forward);
  x.Add("backward|backwards|back|rearward|rearwards|in reverse|to the rear|to the back", M::kDirection, backward);
  x.Add(
      "slow|slowly|at a slow pace|gently|gingerly|carefully|cautiously|at a leisurely pace|leisurely|at a slow speed|"
      "nice and slow|nice and slowly|more slowly|unhurriedly|at a crawl|at a snail's pace|without rushing|take your "
      "time|no rush|taking your time|"
      "without hurrying|in no hurry|a bit slower|slower|very slowly|real slow|nice and easy|softly|steady as she goes",
      M::kPace, "slow");
  x.Add(
      "fast|quickly|quick|rapidly|briskly|swiftly|at a fast pace|hurriedly|at a brisk pace|speedily|at high speed|"
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

void AddOtherActions(Lexicon& x) {
  const std::string left = "left";
  x.Add(
      "turn|turns|turning|rotate|rotating|spin|spinning|pivot|pivoting|face|swivel|twist|swing|veer|yaw|whirl|twirl|"
      "turned|rotated|spun|hang a|hang|bear",
      M::kAction, "turn");
  x.Add(
      "turn around|turning around|turn round|turn back|about face|about-face|about turn|do a 180|u turn|u-turn|"
      "face the other way|turn right around|turn yourself around|turn about",
      M::kAction, "turn", 0.0, {{"direction", left}, {"angle_deg", 180.0}});
  x.Add("spin around|spin round|spinning around|turn in a circle|go around in a circle|turn full circle|twirl around",
        M::kAction, "turn", 0.0, {{"direction", left}, {"angle_deg", 360.0}});
  x.Add("take a left|make a left|take a left turn|make a left turn|do a left turn", M::kAction, "turn", 0.0,
        {{"direction", left}});
  x.Add("take a right|make a right|take a right turn|make a right turn|do a right turn", M::kAction, "turn", 0.0,
        {{"direction", std::string("right")}});
  x.Add("clockwise", M::kSide, "right");
  x.Add("counterclockwise|counter-clockwise|counter clockwise|anticlockwise|anti-clockwise|anti clockwise", M::kSide,
        "left");
  x.Add(
      "stand|standing|stand still|standing still|stay|stay still|wait|waiting|pause|pausing|stop|stopping|halt|"
      "don't move|do not move|dont move|freeze|hold still|hold your position|hold position|stay put|stay there|"
      "stay where you are|remain|remain still|rest|stop there|stop moving|come to a stop|keep still|stand there|"
      "stand by|stand at ease|stay in place|wait there|idle|waited|paused|stood still|hold it there|take a break|take "
      "a breather|catch your breath|stand firm|"
      "hold your ground|come to a halt|come to a standstill|keep quite still|stand perfectly still|don't budge|"
      "not move|stay right there|stay where you are|bide your time|hang around|linger",
      M::kAction, "stand");
  x.Add(
      "stand up|standing up|get up|getting up|rise|rising|get to your feet|get on your feet|get back up|"
      "stand back up|rise up|get back on your feet|stand tall|on your feet|up you get|straighten up|"
      "come up|stand upright|back on your feet|get back to your feet|jump up|pick yourself up|stood up|got up|rise to "
      "your feet|hop up|up on your feet|stand on your feet|"
      "get on up|rise again|stand again|up again|back up again|get yourself up",
      M::kAction, "stand_up");
  x.Add(
      "lie down|lying down|lay down|laying down|lie|lie flat|lie on your belly|lie on the floor|lie on the ground|"
      "go prone|get down on your belly|flop down|drop to the ground|lay flat|lie low|lay yourself down|"
      "down on your belly|lie on your stomach|go to sleep|take a nap|lie-down|have a lie down|have a lie-down|lie "
      "yourself down|lain down|lied down|"
      "down boy|down you go|on your belly|belly down|drop flat|hit the deck|go flat|stretch out on the floor|"
      "get down on the floor|get down on the ground|get on the floor|get on the ground|settle down on the ground",
      M::kAction, "lie_down");
  x.Add(
      "sit|sitting|sit down|sitting down|take a seat|have a seat|be seated|sit on the floor|sit yourself down|"
      "sit back|sit like a dog|sit there|sit still|sat|sat down|seat yourself|park yourself|plonk yourself "
      "down|sit-down|"
      "take a sit|have a sit|have a sit down|sit for a bit|plop down|park your bottom|bum on the floor",
      M::kAction, "sit");
  x.Add(
      "squat|squats|squatting|squat down|squatting down|crouch|crouch down|crouching down|duck|ducking|duck down|"
      "bend your knees|bending your knees|bend the knees|knee bend|knee bends|do squats|deep squat|deep squats|"
      "lower your body|lower yourself|get down low|hunker down|bend down|bend your legs|dip down|kneel|kneel "
      "down|squatted|crouched down low|get low|go low|sink down|go down into a squat|"
      "drop into a squat|get into a squat|sink into a squat|go into a crouch|drop into a crouch|knee-bend|knee-bends|"
      "knees bend|bob down|hunch down|make yourself small|make yourself smaller|get down",
      M::kAction, "squat");
  x.Add(
      "bow|bows|bowing|take a bow|bow down|make a bow|bow politely|bow to the audience|lean forward|bow deeply|"
      "bend forward|bowed|deep bow|take a deep bow|bend over|bow your head|bow from the waist|bend at the waist|"
      "bend from the waist|incline your body|lean over|curtsy|curtsey|do a bow",
      M::kAction, "bow");
  x.Add(
      "nod|nods|nodding|nod your head|nodding your head|nod with your head|bob your head|nod yes|say yes with your "
      "head|"
      "nodded|give a nod|give us a nod|nod in agreement|show agreement|dip your head|"
      "nod your agreement|nod approvingly|say yes",
      M::kAction, "nod");
  x.Add(
      "wave|waves|waving|wave hello|wave goodbye|waving hello|wave hi|wave bye|say hello with|say hi with|greet|"
      "greet with|say hello|say hi|say goodbye|wave your arm about|give a wave|wiggle|"
      "waved|wag|flap|flapping|shake your hand about|give a little wave|say farewell|bid farewell|"
      "greeting|salute|flutter|swing your hand|waggle",
      M::kAction, "wave");
  x.Add(
      "balance|balancing|stand on one leg|standing on one leg|stand on one foot|standing on one foot|balance on|"
      "balancing on|stand on|standing on|stand only on|stand just on|"
      "balanced|stand with only|hop on|stay on|pose on|do the flamingo|"
      "stand like a flamingo|stand like a stork|do a flamingo|flamingo pose|keep your balance on|rest on",
      M::kAction, "balance");
  x.Add("one leg|one foot|one legged|one-legged|a single leg|a single foot", M::kFoot, "one");
  x.Add(
      "brace|brace yourself|bracing yourself|brace for impact|brace for a fall|brace for an impact|protect yourself|"
      "protecting yourself|get ready to fall|prepare to fall|prepare for a fall|prepare for impact|"
      "get ready for a fall|get ready for impact|assume the brace position|brace position|shield yourself|"
      "take the brace position|protective crouch|protective posture|protective position|take cover|"
      "curl up for a fall|guard yourself|go into a protective crouch|get into a protective crouch|"
      "braced|brace for it|brace now|ready yourself for a fall|protect your head|"
      "be ready to fall|cover yourself|curl up|make ready for a fall|ready for impact|prepare yourself for a fall|"
      "prepare yourself for impact|guard against a fall|brace up|get set for a fall|get set for impact|crash position|"
      "adopt the brace position|fall protection|get ready to be pushed|prepare to be pushed",
      M::kAction, "brace");
  x.Add(
      "raise|raises|raising|lift|lifting|lift up|raise up|hold up|holding up|pick up|stick up|throw up|"
      "put up|reach up with|reach up|stretch up|hoist|elevate|raised|lifted|held up|held high|holding high|hold "
      "high|lifts|"
      "put in the air|stick in the air|keep up|keeping up",
      M::kRaise);
  x.Add("lower|lowers|lowering|lowered|dropped|drop|dropping|put down|let down|bring down|take down|relax", M::kLower);
  x.Add(
      "put|putting|bring|bringing|stick|throw|shoot|fling|place|pick|keep|get both|let|get your|stretch|hold "
      "your|holding your|keep your|with your",
      M::kPut);
  x.Add(
      "up|upward|upwards|in the air|into the air|up high|up in the air|high|overhead|above your head|to the sky|"
      "skyward|over your head",
      M::kUp);
  x.Add(
      "down|downward|downwards|back down|down again|to your side|to your sides|at your side|by your side|by your sides",
      M::kDown);
  x.Add("jump|jumping|hop|hopping|leap|leaping|skip|climb|climbing|crawl|crawling|swim|fly|dance|dancing|gallop|sprint",
        M::kElsewhere, "walk");
}

void AddLimbsAndAmounts(Lexicon& x) {
  x.Add(
      "left|left-hand|leftward|leftwards|to the left|to your left|on the left|towards the left|toward the left|"
      "to left|to its left|left side|port|on your left",
      M::kSide, "left");
  x.Add(
      "right|right-hand|rightward|rightwards|to the right|to your right|on the right|towards the right|"
      "toward the right|to right|right side|starboard|on your right",
      M::kSide, "right");
  x.Add("both", M::kBoth);
  x.Add("arm|hand|forearm|paw", M::kArm);
  x.Add("arms|hands|paws", M::kPlural);
  x.Add("foot|leg", M::kFoot);
  x.Add(
      "full turn|whole turn|complete turn|full circle|full rotation|complete rotation|full revolution|full spin|"
      "complete circle|whole circle",
      M::kAmount, "turns", 360.0);
  x.Add("half turn|half a turn|half-turn|half circle|half rotation", M::kAmount, "turns", 180.0);
  x.Add("three-quarter turn|three quarter turn|three-quarters turn", M::kAmount, "turns", 270.0);
  x.Add("quarter turn|quarter-turn|quarter of a turn", M::kAmount, "turns", 90.0);
  x.Add("once", M::kAmount, "times", 1.0);
  x.Add("twice", M::kAmount, "times", 2.0);
  x.Add("thrice", M::kAmount, "times", 3.0);
  x.Add("first", M::kOrdinal, "", 1.0);
  x.Add("second", M::kOrdinal, "", 2.0);
  x.Add("third|3rd", M::kOrdinal, "", 3.0);
  x.Add("fourth|4th", M::kOrdinal, "", 4.0);
  x.Add("fifth|5th", M::kOrdinal, "", 5.0);
  x.Add("sixth|6th", M::kOrdinal, "", 6.0);
  x.Add("seventh|7th", M::kOrdinal, "", 7.0);
  x.Add("eighth|8th", M::kOrdinal, "", 8.0);
  x.Add("ninth|9th", M::kOrdinal, "", 9.0);
  x.Add("tenth|10th", M::kOrdinal, "", 10.0);
  x.Add("1st", M::kOrdinal, "", 1.0);
  x.Add("2nd", M::kOrdinal, "", 2.0);
  x.Add("last|final|furthest|farthest", M::kOrdinal, "", -1.0);
  x.Add("each|apiece|per step|every step|each step|in length|long", M::kEach);
}

void AddUnits(Lexicon& x) {
  x.Add("m|metre|metres|meter|meters|mtrs", M::kUnit, "m", 1.0);
  x.Add("cm|centimetre|centimetres|centimeter|centimeters|cms", M::kUnit, "m", 0.01);
  x.Add("mm|millimetre|millimetres|millimeter|millimeters", M::kUnit, "m", 0.001);
  x.Add("km|kilometre|kilometres|kilometer|kilometers|kms", M::kUnit, "m", 1000.0);
  x.Add("decimetre|decimetres|decimeter|decimeters|dm", M::kUnit, "m", 0.1);
  x.Add("ft|feet|foot", M::kUnit, "m", 0.3048);
  x.Add("inch|inches|in", M::kUnit, "m", 0.0254);
  x.Add("yard|yards|yd|yds", M::kUnit, "m", 0.9144);
  x.Add("mile|miles", M::kUnit, "m", 1609.344);
  x.Add("s|sec|secs|second|seconds", M::kUnit, "s", 1.0);
  x.Add("ms|millisecond|milliseconds", M::kUnit, "s", 0.001);
  x.Add("min|mins|minute|minutes", M::kUnit, "s", 60.0);
  x.Add("h|hour|hours|hr|hrs", M::kUnit, "s", 3600.0);
  x.Add("deg|degs|degree|degrees|°", M::kUnit, "deg", 1.0);
  x.Add("rad|rads|radian|radians", M::kUnit, "deg", 180.0 / std::numbers::pi);
  x.Add("turn|turns|rotation|rotations|revolution|revolutions|circle|circles|spin|spins|round", M::kUnit, "turns",
        360.0);
  x.Add("step|steps|pace|paces|footstep|footsteps|stride|strides|small steps|little steps|big steps|tiny steps",
        M::kUnit, "steps", 1.0);
  x.Add("time|times|repetitions|reps|repetition", M::kUnit, "times", 1.0);
  x.Add(
      "m/s|mps|metres per second|meters per second|metre per second|meter per second|metres a second|"
      "meters a second|metre a second|meter a second|m per second|m a second|metres/second|meters/second|m per s|"
      "metres every second|metres each second",
      M::kUnit, "m/s", 1.0);
  x.Add(
      "cm/s|centimetres per second|centimeters per second|cm per second|centimetres a second|centimeters a second|"
      "centimetre per second|cm a second",
      M::kUnit, "m/s", 0.01);
  x.Add("mm/s|millimetres per second|millimeters per second|mm per second", M::kUnit, "m/s", 0.001);
  x.Add(
      "km/h|kmh|kph|kilometres per hour|kilometers per hour|kilometres an hour|kilometers an hour|km per hour|"
      "km an hour|kilometre per hour|kilometer per hour|kilometre an hour|kilometer an hour",
      M::kUnit, "m/s", 1.0 / 3.6);
  x.Add("mph|miles per hour|miles an hour|mile per hour", M::kUnit, "m/s", 0.44704);
  x.Add("feet per second|ft/s|foot per second|feet a second", M::kUnit, "m/s", 0.3048);
}

void AddJoints(Lexicon& x) {
  x.Add(
      "then|and then|after that|afterwards|afterward|next|finally|lastly|and finally|and next|and|and after that|"
      "followed by|and now|plus|subsequently|thereafter|when you get there|once you get there|when you're there|"
      "once you're there|once there|when you arrive|once you arrive|when you are there|when done|when you're done|"
      "once done|when you have done that|once you have done that|when finished|as soon as you get there|"
      "to finish|to begin|to start|to start with|first of all|last of all|at the end|in the end|before finally|"
      "when that's done|once that's done|upon arrival|on arrival|when you reach it|once you reach it|and last|"
      "as a last step|after which|immediately",
      M::kThen);
  x.Add(
      "while|whilst|at the same time|simultaneously|meanwhile|as you do so|as you do that|as you do|as you go|"
      "while you do so|while you do that|as you walk|at once|during that|and at the same time|in the meantime|while "
      "you|"
      "whilst you|as you|while you are|while you're|all the while|along the way|on the way|while doing so|while you go|"
      "while doing that|during which|and meanwhile|concurrently|and simultaneously",
      M::kWhile);
  x.Add("before|before you|but before you|but before that|prior to", M::kBefore);
  x.Add(
      "after|after you|once you have|once you've|as soon as you have|when you have|when you've|after you have|"
      "after you've|having|once you are done|once you finish|after you finish|when you finish",
      M::kAfter);
  x.Add(
      "no|nope|no wait|wait no|sorry|i mean|i meant|rather|or rather|make that|make it|correction|instead|oops|"
      "my mistake|pardon|excuse me|actually|well actually|no no|oh no|no make that|no make it|i mean to say|"
      "sorry i meant|no sorry|actually no|scratch that make it|let me correct that|i should say|wait|hang on|"
      "hold on|hmm no|better make that|let's make that|no i mean|no i meant|on second thought|on second thoughts|oh "
      "sorry|"
      "err no|uh no|um no|better|change that to|let's say|that should be|should be|it should be|or better",
      M::kNo);
  x.Add("not", M::kNot);
  x.Add(
      "don't|do not|dont|never mind|nevermind|scratch that|forget it|forget that|forget about it|cancel that|"
      "strike that|skip that|ignore that|actually don't|no don't|leave it|drop that|cancel|not that|"
      "don't do that|do not do that|on second thought don't|disregard that|undo that|forget about that",
      M::kDrop);
  x.Add(
      "again|once more|one more time|repeat|repeat that|do it again|do that again|and again|the same again|"
      "same again|repeat it|do that once more|do it once more|encore|do the same again",
      M::kAgain);
  x.Add(
      "hold|hold it|hold that|holding it|hold this|keep it|keep that|stay down|stay low|keep it up|hold there|"
      "hold the position|hold the pose|hold that pose|hold that position|maintain it|stay like that|"
      "stay that way|and hold|hold on to it|remain there|stay in that position|stay there",
      M::kHold);
  x.Add(
      "to|over to|towards|toward|up to|until|reach|reaching|as far as|onto|on to|all the way to|up onto|"
      "to reach|until you reach|until you get to|till|over towards|in the direction of|in front of",
      M::kTo);
  x.Add("at|to the crowd|to everyone|to us|to me|to them|to everybody|for us|for me|for everyone", M::kAt);
  x.Add(
      "please|could you|can you|would you|will you|would you please|could you please|can you please|kindly|"
      "would you mind|i'd like you to|i would like you to|i want you to|i'd love you to|i need you to|you should|"
      "you can|you could|you may|let's|lets|let us|try to|try|go ahead|go on|now|ok|okay|so|well|um|uh|er|erm|hmm|"
      "hey|hi|hello|robot|nao|buddy|dear|dog|doggy|boy|good boy|listen|alright|all right|right then|thanks|"
      "thank you|thank you very much|if you please|if you can|if you could|if possible|pretty please|for me "
      "please|just|"
      "simply|my friend|friend|mate|puppy|little robot|good dog|oh|ah|yes|yeah|quite|maybe|perhaps|"
      "i wonder if you could|do you think you could|if you would|if you don't mind|would you be so kind as to|"
      "be so kind as to|be so good as to|do me a favour and|do me a favor and|a1|everyone|you must|you need to|"
      "you have to|it's time to|time to|your task is to|the task is to|start by|begin by|finish by|end by|proceed to|"
      "you to|we want you to|it would be nice if you could|may i ask you to|might you|get ready and|"
      "go ahead and|go and|and please|also|too|still|simply just|come on|c'mon|there's a good dog|immediately now|"
      "right now|could i get you to|how about you|how about|my teacher wants you to|the teacher wants you to|wants you "
      "to|"
      "i'd appreciate it if you could|i'd appreciate it if you|i'd be grateful if you could|i'd be glad if you|"
      "you're about to fall|you are about to fall|you're going to fall|you are going to fall|you're falling|watch out|"
      "careful|look out|attention|let me see you|let me see|let's see you|let's see|i'd love to see you|show us how "
      "you|"
      "show me how you|can i see you|can we see you|may i see you|what about|why don't you|why not|how about we|"
      "would it be possible to|is it possible for you to|are you able to|do you mind|i wonder whether you could|"
      "i need you|i want you|i'd like you|tell it to|have it|be a dear and|be a good dog and|be a good boy and|"
      "there's a good boy|good girl|everybody's watching|everyone's watching|everyone is watching|mind|and so|so then|"
      "your next task is to|your job is to|the next thing is to|we'd like you to|we would like you to|"
      "go and have|come on and|feel free to|make sure to|remember to|don't forget to|be sure to|ready|steady now|"
      "if it's not too much trouble|if you wouldn't mind|if you like|at your convenience|when you're ready|"
      "once you're ready|whenever you're ready|on my mark|on my signal|start|begin|straight away|right away|at "
      "ease|first of all please|for a start",
      M::kPolite);
  x.Add(
      "the|of|by|for|about|roughly|approximately|around|exactly|a|an|your|my|it|them|him|her|its|that|this|these|"
      "those|with|on|in|from|over|there|here|you|me|us|some|total|distance|a distance of|angle|speed|a speed of|"
      "at a speed of|with a speed of|at a pace of|rate|a rate of|at a rate of|velocity|at a velocity of|one|ones|"
      "is|are|be|will|head|body|knees|legs|as|like|very|nearly|almost|more|further|another|place|spot|on the spot|"
      "in place|ground|floor|period|duration|for a duration of|for a period of|through|off|out|set|depth|a depth of|"
      "to a depth of|at an angle of|an angle of|through an angle of|or so|good|nice|big|little|small|side|direction|"
      "way|low|full|fully|completely|all|again and|politely|friendly|happily|bit|way back|with a|steady|steadily|"
      "own|per|every|worth|count|forth|down to|up and|at a|at about|starting|and a|at speed|speed of|only|then just|"
      "where|who|steps forward|lovely|proper|single|i|we|he|she|they|does|did|that is|length|long "
      "each|size|number|no|off the floor|off the ground|"
      "deep|in depth|from there|each time|more time|the whole time|worth of|"
      "high up|goes|reps of|each way|apart|that way|facing|yourself|together|self|towards me|in total|altogether|"
      "in one go|if|so that|carry|bit further|own two feet|either|both of|both your|of them|in a row|straight up|"
      "across|along|gracefully|elegantly|enthusiastically|vigorously|warmly|briefly|smartly|proudly|calmly|quietly|"
      "smoothly|firmly|high above|robotically|cheerfully|kindly now|well away|audience|crowd|visitors|lab|room|"
      "hello there|long enough|spread|still now|rest of",
      M::kFiller);
}

}  // namespace

const Lexicon& English() {
  static const Lexicon lexicon = [] {
    Lexicon x;
    AddWalking(x);
    AddOtherActions(x);
    AddLimbsAndAmounts(x);
    AddJoints(x);
    return x;
  }();
  return lexicon;
}

const Lexicon& EnglishUnits() {
  static const Lexicon units = [] {
    Lexicon x;
    AddUnits(x);
    return x;
  }();
  return units;
}

}  // namespace gaitwright::words
