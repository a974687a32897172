// SPDX-License-Identifier: BSD-3-Clause
// English words for all that is done but walking.
#include <string>

#include "workflows/words/lexicon_internal.h"

namespace gaitwright::words {
namespace {

using M = Meaning;

}  // namespace

void AddEnglishActions(Lexicon& x) {
  x.Add(
      "go all the way round|go all the way around|go right round|go right around|spin all the way around|"
      "spin all the way round",
      M::kAction, "turn", 0.0, {{"angle_deg", 360.0}});
  x.Add("go round|go around", M::kAction, "turn");
  x.Add("give me your paw|give paw|shake hands|shake paws|high five|give me five|shake my hand", M::kElsewhere, "wave");
  x.Add(
      "come here|come over here|come on over here|come to me|come over to me|come to us|come over to us|come over|"
      "come closer|come nearer|get over here|walk here|walk over here|run here|run over here|walk to me|walk to us|"
      "walk towards me|walk over to me",
      M::kElsewhere, "walk");
  x.Add("recover|recover from a push|recover from pushes|recover your balance|catch yourself|regain your balance",
        M::kElsewhere, "recover");
  x.Add("walk the dog|walk my dog|walk the dogs|follow me|follow him|follow her|come with me|chase", M::kElsewhere,
        "walk");
  x.Add("nod head|nod ur head|nod the head|nodding head", M::kAction, "nod");
  x.Add("rot|rotate|yaw", M::kAction, "turn");
  x.Add("ccw", M::kSide, "left");
  x.Add("cw", M::kSide, "right");
  x.Add("bal|bal.", M::kAction, "balance");
  x.Add("bye-bye|bye bye|make bye-bye|make bye bye|make hello|say bye-bye", M::kAction, "wave");
  x.Add("wait right there|wait right here|hang on for|hold on for|wait for|hang about for|hang about", M::kAction,
        "stand");
  x.Add("prepare for a crash|prepare for the fall|prepare for crash|prepare for the crash|get ready for the fall",
        M::kAction, "brace");
  x.Add(
      "face backwards|face backward|face the opposite way|face the opposite direction|do an about-face|do an about "
      "turn|"
      "do a u-turn|make a u-turn|do a u turn|turn back around|turn all the way around|spin right round|"
      "turn to face the other way|turn and face the other way|turn to face the opposite direction|turn your back|"
      "turn the other way|reverse direction|reverse your direction|turn yourself round|swing around|swing round|"
      "wheel around|whip around|flip around|look behind you|face behind you|do a one-eighty|pull a 180|"
      "make a 180|turn a full 180|one eighty|one-eighty",
      M::kAction, "turn", 0.0, {{"direction", std::string("left")}, {"angle_deg", 180.0}});
  x.Add(
      "do a 360|pull a 360|make a 360|do a three-sixty|three-sixty|do a pirouette|pirouette|go round in a circle|"
      "turn once around|turn round once|turn all the way round|twirl round|go full circle",
      M::kAction, "turn", 0.0, {{"direction", std::string("left")}, {"angle_deg", 360.0}});
  x.Add(
      "angle|orient yourself|reorient|rotate yourself|turn yourself|wheel|swing yourself|whirl around|circle|"
      "take a turn|make a turn|do a turn|shift to face|look",
      M::kAction, "turn");
  x.Add(
      "stay standing|stand motionless|be still|don't go anywhere|stay as you are|keep standing|halt there|hold up|"
      "hold fire|stop for|pause there|wait a moment|wait a bit|hang tight|sit tight|do nothing|don't do anything|"
      "stay exactly where you are|stay frozen|stand fast|stand ready|cool your heels|stop right there|stop where you "
      "are|"
      "hold it right there|take a pause|have a rest|have a break|rest there|rest a while|tarry|stand idle|remain where "
      "you are|"
      "remain standing|remain stationary|stay stationary|be stationary|keep your position|stay motionless",
      M::kAction, "stand");
  x.Add(
      "get up off the floor|get up off the ground|rise and shine|get vertical|get up on all fours|up on all fours|"
      "get onto your feet|get yourself upright|get upright|stand yourself up|pop up|pop back up|spring up|"
      "come back up|come up again|get on your legs|stand on all fours|arise|stand to attention|wake up|rise back up|"
      "straighten your legs|straighten back up|return to standing|go back to standing|back to standing",
      M::kAction, "stand_up");
  x.Add(
      "lie down flat|lie on the deck|lay on the floor|lay on the ground|lay on your belly|lie right down|"
      "have a lie|drop to your belly|get down flat|flatten yourself|lie yourself flat|take a rest on the floor|"
      "rest on your belly|belly flop|play dead|crash out|doze off|curl up on the floor|assume a prone position|prone|"
      "get prone|lower yourself to the ground|lower yourself onto your belly|lie on your tummy|lay down flat|lie there|"
      "go down on your belly|settle on the floor|settle down on the floor|stretch out|on the ground please",
      M::kAction, "lie_down");
  x.Add(
      "sit right down|sit on your haunches|sit on your bottom|sit on your hind legs|sit on your butt|sit for|"
      "sit pretty|get seated|settle into a sit|assume a sitting position|go into a sit|get into a sit|bottom down|"
      "take a load off|sit up nicely|sit nicely|sit properly|sit your bottom down|rest on your haunches",
      M::kAction, "sit");
  x.Add(
      "do a squat|do a knee bend|do a deep squat|give me a squat|squatting position|go into a deep squat|sit into a "
      "squat|"
      "flex your knees|flex your legs|bend at the knees|bend those knees|lower yourself down|lower your hips|"
      "drop your hips|drop down|drop your body|crouch low|crouch right down|get down into a crouch|hunker|scrunch down|"
      "sink|sink lower|go down low|dip|dip your body|stoop|stoop down|duck your head|hit the floor|make yourself low|"
      "get yourself low|take a knee|plie|do some squats|knees bent|half squat|shallow squat|air squat|air squats",
      M::kAction, "squat");
  x.Add(
      "bend over forwards|bend forwards|lean forwards|tilt forward|tilt forwards|tip forward|incline forward|stoop "
      "forward|"
      "bow low|give a bow|give us a bow|give me a bow|bow graciously|bow respectfully|pay your respects|kowtow|"
      "make a deep bow|take a little bow|do a little bow|bow before us|bow before me|bend your body forward|"
      "lower your upper body|curtsey for us|play bow|do a play bow|bow your body",
      M::kAction, "bow");
  x.Add(
      "nod along|nod away|keep nodding|nod a yes|give a little nod|give me a nod|give a quick nod|nod "
      "gently|bob|bobbing|"
      "bob your head up and down|move your head up and down|shake your head yes|wag your head up and down|"
      "tip your head|dip your chin|lower your head and raise it",
      M::kAction, "nod");
  x.Add(
      "keep waving|wave about|wave around|waving at everyone|wave away|give everyone a wave|give them a wave|"
      "give us a wave|give me a wave|give a friendly wave|give a big wave|shake your hand|shake your arm|shake|"
      "move your hand back and forth|swing your arm|swing your arms|say howdy|say good day|say hey|hail|signal|beckon|"
      "say bye|say bye bye|say bye-bye|say cheerio|wish them goodbye|high five the air|wave farewell|greet with a wave|"
      "wave a greeting|do a wave|wave your hand in greeting",
      M::kAction, "wave");
  x.Add(
      "hop on one foot|perch on|perch|teeter on|poise on|hold yourself on|stand solely on|stand just with|"
      "use only|be a flamingo|be a stork|pretend to be a flamingo|do a tree pose|tree pose|stork stance|flamingo "
      "stance|"
      "one-foot stand|one-legged stand|single-leg stand|one-leg stand|do a one-leg stand|single leg stand|"
      "do a single-leg stand|support yourself on|put all your weight on|put your weight on|shift your weight onto",
      M::kAction, "balance");
  x.Add(
      "brace for a tumble|brace for the fall|brace for a crash|brace for collision|prepare to crash|prepare to tumble|"
      "get ready to crash|get ready for a crash|get ready to tumble|get ready for a tumble|get ready to be knocked "
      "over|"
      "prepare to be knocked over|safety position|crash pose|protect your body|keep yourself safe|safe pose|"
      "safety pose|safety crouch|go into brace position|get into the brace position|get into brace position|"
      "assume a protective posture|take a protective posture|assume a protective stance|cover up|tuck in|"
      "go into protection mode|emergency crouch|defensive crouch|defensive position|prepare for a tumble|"
      "prepare for a collision|ready yourself for impact|ready yourself for a tumble|be ready for a fall|"
      "be ready for impact|brace against a push|protect yourself from a fall|protect yourself against a fall",
      M::kAction, "brace");
  x.Add("hands in the air|reach for the sky|stick em up", M::kRaise, "both");
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
      "wave|waves|waving|wave hello|wave goodbye|waving hello|waving goodbye|waving bye|waving bye bye|waving "
      "hi|waving farewell|wave farewell|wave good-bye|waving good-bye|wave hi|wave bye|say hello with|say hi "
      "with|greet|"
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
  x.Add(
      "pop them down|pop it down|pop them back down|pop it back "
      "down|lower|lowers|lowering|lowered|dropped|drop|dropping|put down|let down|bring down|take down|relax",
      M::kLower);
  x.Add(
      "put|putting|bring|bringing|stick|throw|shoot|fling|place|pick|keep|get both|let|get your|stretch|hold "
      "your|holding your|keep your|with your",
      M::kPut);
  x.Add(
      "in the air|into the air|up high|up in the air|high|overhead|above your head|to the sky|"
      "skyward|over your head",
      M::kUp);
  x.Add("to your side|to your sides|at your side|by your side|by your sides", M::kDown);
  x.Add("jump|jumping|hop|hopping|leap|leaping|skip|swim|fly|dance|dancing|gallop", M::kElsewhere, "walk");
}

}  // namespace gaitwright::words
