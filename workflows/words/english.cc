// SPDX-License-Identifier: BSD-3-Clause
#include <numbers>

#include "workflows/words/lexicon_internal.h"

namespace gaitwright::words {
namespace {

using M = Meaning;

void AddLimbsAndAmounts(Lexicon& x) {
  x.Add("like|like a|like an", M::kFiller, "like");
  x.Add(
      "left-hand side|to the left-hand side|on the left-hand side|to the left side|to the left hand side|leftways|"
      "to my left|towards your left|toward your left|on its left|off to the left|over to the left|port side|to port",
      M::kSide, "left");
  x.Add(
      "right-hand side|to the right-hand side|on the right-hand side|to the right side|to the right hand "
      "side|rightways|"
      "to my right|towards your right|toward your right|on its right|off to the right|over to the right|to starboard",
      M::kSide, "right");
  x.Add(
      "left|left-hand|leftward|leftwards|to the left|to your left|on the left|towards the left|toward the left|"
      "to left|to its left|left side|port|on your left",
      M::kSide, "left");
  x.Add(
      "right|right-hand|rightward|rightwards|to the right|to your right|on the right|towards the right|"
      "toward the right|to right|right side|starboard|on your right",
      M::kSide, "right");
  x.Add(
      "with it|with that arm|with that hand|with that one|with the same hand|with the same arm|with the same one|the "
      "same arm|"
      "the same hand",
      M::kSide, "same");
  x.Add(
      "the other one|the other hand|the other arm|with the other|with the other one|with the other hand|other "
      "arm|other hand|"
      "with the other arm|the opposite arm|the opposite hand",
      M::kSide, "other");
  x.Add("the", M::kFiller, "the");
  // What leads to no place, and says nothing elsewhere.
  x.Add("from|around|off|out|through|across|along|by|with|of|in|away|well away|facing|apart|beside you|side|about|as",
        M::kFiller, "relation");
  x.Add("all the way around|all the way round|right round|right around|full three-sixty|full 360", M::kAmount, "turns",
        360.0);
  x.Add("both|two hands|two arms|two paws|both of", M::kBoth);
  x.Add("l", M::kSide, "left");
  x.Add("r", M::kSide, "right");
  x.Add("arm|hand|forearm|paw", M::kArm);
  x.Add("arms|hands|paws", M::kPlural);
  x.Add("foot|leg", M::kFoot);
  x.Add("your head|the head|its head|my head|chin|neck|face", M::kPart, "head");
  x.Add("body|torso|upper body|shoulders|waist", M::kPart, "body");
  x.Add("legs|knees|knee|hips|back leg|back legs|front legs", M::kPart, "legs");
  x.Add("tummy|belly|stomach", M::kPart, "belly");
  x.Add("on your side|on its side|on the side|on your back|on its back", M::kUnknown);
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
  x.Add("each|ea|apiece|per step|every step|each step|in length|long", M::kEach);
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
  x.Add("stair|stairs", M::kUnit, "treads", 1.0);
  x.Add("turn|turns|rotation|rotations|revolution|revolutions|circle|circles|spin|spins|round", M::kUnit, "turns",
        360.0);
  x.Add(
      "step|steps|small step|little step|big step|tiny step|baby step|baby steps|long steps|short steps|more "
      "steps|more step|"
      "further steps|giant steps|large steps|large step|quick steps|slow steps|careful steps|even steps|giant step|"
      "footfall|footfalls|pace|paces|footstep|footsteps|stride|strides|small steps|little steps|big steps|tiny steps",
      M::kUnit, "steps", 1.0);
  x.Add("time|times|repetitions|reps|rep|repetition|x", M::kUnit, "times", 1.0);
  x.Add("m/step|metres/step|meters/step|m a step|m per step|metres a step|meters a step", M::kUnit, "m/step", 1.0);
  x.Add(
      "cm/step|cm/steps|cm a step|cm per step|centimetres a step|centimeters a step|centimeters per step|"
      "centimetres per step",
      M::kUnit, "m/step", 0.01);
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
  x.Add("as soon as you've|as soon as you have|as soon as you|once you|when you|the moment you've|the moment you have",
        M::kAfter);
  x.Add("skip the|skip your|no more|leave out the|drop the", M::kDrop);
  x.Add(
      "when you have done so|when you've done so|once you have done so|once you've done so|once all of that is done|"
      "once all that is done|once that's all done|when all of that is done|when all that is done|once all this is done|"
      "after all that|after all of that|once it is done|once it's done|when it's done|when it is done|"
      "as soon as that is done|as soon as that's done|after doing that|after doing so|once finished|upon finishing|"
      "when you finish that|once you finish that|when you're finished|once you're finished|then after|then after that|"
      "switch to|switch to a|change to|change to a|change gait to|switch gait to|and switch to|and change to|then "
      "switch to|"
      "then change to|then after this|immediately after|straight after that|right after that|right after|soon "
      "after|and when you are "
      "there|and when you're there|and when you get there|and once you're there|and once you get there|and once there|"
      "and when you arrive|and once you arrive|and when that is done|and once that is done|and when done|and once done|"
      "and when you have done so|and when you've done so|and when you're done|and when you are done|when you are done|"
      "once you are done with that|when you're through|once you are there|once you have arrived|when you have arrived",
      M::kThen);
  x.Add(
      "darlin'|superstar|private|corporal|sergeant|pup|pupper|doggo|upsy-daisy|upsy "
      "daisy|maestro|professor|doc|captain|chief|"
      "boss|kiddo|fella|lads|eh|aw|aww|woohoo|hooray|bravo|great job|good work|nice job|lovely job|test "
      "sequence|test|from the top|"
      "ladies and gentlemen|i wonder whether|i wonder if|you might|you could|you may|ought to do it|should do it|will "
      "do it|"
      "will do|is enough|is plenty|should be enough|that's enough|would do|should suffice|will suffice|and that's "
      "it|that's it|"
      "that's all|and that's all|that is all|and that is all|no more than that|on three|ready set go|ready steady go|"
      "show time|showtime|lights camera action|action please|cue|curtain up|stage directions|"
      "mr|mrs|ms|miss|dr|my dear|my dog|my boy|my girl|my good dog|my good fellow|my lad|my love|my robot|my little "
      "friend|my sweet|"
      "old chap|old boy|pal|bud|darling|sweetheart|honey|hon|love|champ|big guy|little guy|little one|little buddy|"
      "soldier|cadet|unit|rover|fido|spot the dog|bot|robo|robot must|robot should|robot will|robot can|"
      "whenever you feel ready|when you feel ready|whenever you feel like it|whenever it suits you|when you get a "
      "chance|when you have a moment|when you've a moment|if you have a moment|if you have time|if it suits you|"
      "warm-up|warm up|warmup|drill|routine|sequence|program|programme|exercise|new task|task|next task|cmd|command|"
      "instruction|instructions|order|orders|steps as follows|as follows|do the following|do this|the following|"
      "but|however|um yeah|yep|yup|uh huh|well done|good job|great|perfect|nice one|nice work|brilliant|excellent|"
      "thanks in advance|thx|tks|pls|plz|ty|if you will|if you'd like|would be nice|would be great|over and out|over|"
      "copy that|roger|attention please|everybody ready|is that ok|is that okay|ok with you|got it|you got it|"
      "got that|you know|you see|see|look|i guess|i think|i suppose|if that's ok|if that's okay|if that's alright|"
      "if that is all right|if that's all right|as usual|like before|as before|like last time|as we practised|"
      "as we practiced|like we practised|like we practiced|like you did before|like yesterday",
      M::kPolite);
  x.Add("@|reps|rep|cadence|heading|amount|dist|dur|qty|num|approx.|approx|no.|to about|in place now", M::kFiller);
  x.Add("mister|would ya|wouldja|will ya|could ya|can ya|ya|gonna|you're about to be hit|you are about to be hit",
        M::kPolite);
  x.Add("nice and|shall we|would you|will you please|like a|like an", M::kFiller);
  x.Add(
      "walk on the spot|walking on the spot|march in place|march on the spot|walk in place|jog on the spot|"
      "jog in place|run on the spot|run in place",
      M::kElsewhere, "walk");
  x.Add(
      "and also|and afterwards|and following that|following that|having done that|with that done|that done|"
      "once you've done that|after this|from then on|and lastly|and as a finale|as a finale|to round off|to round it "
      "off|"
      "to end|to conclude|to top it off|second of all|third of all|in turn|whereupon|upon getting there|on reaching it|"
      "once you make it there|when you make it there|once you've arrived|when you've arrived|once you've made it|"
      "at that point|for the first part|for the second part|for starters|first off|firstly|secondly|thirdly|"
      "last but not least|to kick off|kick off with|kicking off with|finish off with|finish with|end with|"
      "finish off by|ending with|finishing with|starting with|beginning with|start with|begin with|once that is done|"
      "when that is done|as soon as you arrive|the moment you arrive|the moment you get there|on getting there",
      M::kThen);
  x.Add(
      "all while|while also|at the very same time|in parallel|as well as|during this|during this time|throughout|"
      "while at it|as you move|while moving|in the process|whilst doing so|along with|together with|while still|"
      "while you're doing that|while you are doing that|while you're at it|as you're going|simultaneously with",
      M::kWhile);
  x.Add("let's not", M::kForbid);
  x.Add("don't bother|no need|no need to|not need you to|not need you|not need to|you don't need to|you don't have to",
        M::kForbid, "needless");
  x.Add(
      "no|nope|no wait|wait no|no no|oh no|actually no|hmm no|err no|uh no|um no|erm no|oops no|ah no|hang on no|"
      "hold on no|no hang on|no hold on|no that's wrong|no that's not right|that's not right|that's wrong|wrong",
      M::kNo, "no");
  x.Add(
      "erm no|err|oops no|oops sorry|ah no|ah sorry|hang on no|hold on no|scrap that make it|no hang on|no hold on|"
      "i take that back|let me rephrase|let me correct myself|correcting myself|what i meant was|what i mean is|"
      "i meant to say|that's wrong|wrong|not quite|no not that|on reflection|or should i say|or better yet|"
      "change of plan|change of plans|make that rather|no scratch that make it|whoops|silly me|apologies|my bad|"
      "no that's wrong|no that's not right|that's not right|i misspoke|beg your pardon|or make that|or make it",
      M::kNo);
  x.Add(
      "scrap that|scratch it|scrub that|no forget that|no forget it|forget what i said|ignore what i said|"
      "ignore the last bit|ignore that last bit|ignore the last one|take that back|cancel the last one|never mind that|"
      "nevermind that|forget i said that|no need for that|no never mind|oh never mind|"
      "actually never mind|actually forget it|actually forget that|actually scratch that|abort|abort that|bin that|"
      "drop it|skip it|strike it|delete that",
      M::kDrop);
  x.Add(
      "and once more|another time|a second time|and do it again|and do that again|do the same|same once more|once "
      "again|"
      "one more|redo that|redo it|repeat the same|repeat the last one|repeat the last step|and repeat|over again|"
      "again please|let's have that again|let's see that again|play it again|and another|and another one|"
      "do another one|do one more",
      M::kAgain);
  x.Add(
      "hold steady|hold like that|and stay there|and stay like that|maintain that|maintain the pose|"
      "maintain that pose|maintain the position|maintain that position|keep holding|keep it like that|keep that pose|"
      "keep that position|keep the pose|freeze there|freeze like that|stay like this|keep it there|"
      "stay up|keep them up|stay down there|keep down|remain like that|remain in that position|hold yourself there|"
      "sustain it|sustain that|keep still like that",
      M::kHold);
  x.Add(
      "would you be able to|i want to see you|i'd like to see you|i would like to see you|i need to see you|"
      "it would be great if you could|it'd be great if you could|it would be lovely if you could|it'd be lovely if you "
      "could|"
      "could we have you|could we get you to|can we get you to|can i get you to|can i ask you to|could i ask you to|"
      "might i ask you to|may i request that you|i request that you|i ask that you|i'm asking you to|i'm telling you "
      "to|"
      "you are to|you're to|be good enough to|be so good as to|be kind enough to|do be so kind as to|"
      "if it isn't too much trouble|if it's no trouble|if you'd be so kind|if you would be so kind|if you don't object|"
      "for the camera|for the audience|for the crowd|for the kids|for the class|for the children|for your audience|"
      "there you go|here we go|here goes|right|ahem|uhm|umm|ooh|aha|yo|oi|attaboy|good robot|dear robot|mr robot|"
      "hello robot|hey robot|okay robot|ok robot|listen up|pay attention|heads up|excuse me|pardon me|say|"
      "how's about you|what do you say you|what if you|suppose you|fancy|do you fancy|care to|would you care to|"
      "do you want to|would you like to|i suggest you|i suggest that you|i'd suggest you|we need you to|the plan is to|"
      "your mission is to|your goal is to|your first task is to|your instructions are to|next up|now then|now please|"
      "quick as you can|without delay|at once please|this instant|immediately please|asap|as soon as possible|"
      "go ahead and please|please go ahead and|just go and|just go|let's try|let's have you|let's get you to|"
      "let's start by|we'll start by|we'll begin by|you'll|you will|you need|i'll need you to|i'm going to need you to|"
      "i am going to need you to|it's safe to|try and|attempt to|see if you can|let's see if you can|i bet you can|"
      "show me that you can|prove you can|there's a good dog|there's a good lad|good lad|lad|sweetie|sir|madam|"
      "thank you kindly|many thanks|cheers|ta|much obliged|thanks a lot|thanks so much|with pleasure|kindly please",
      M::kPolite);
  x.Add(
      "a bit|a little|a little bit|a tad|slightly|a touch|somewhat|a smidge|precisely|"
      "approx|circa|just about|more or less|not more than|no more than|up to about|at least|worth|away|further on|"
      "from where you are|from here|from your current position|where you are|where you're standing|overall|nicely|"
      "in a straight line|in a line|in one direction|in that direction|that direction|each leg|the spot|right where "
      "you are|"
      "beside you|in front|in front of you|onwards from there|from that spot|properly|carefully "
      "now|eagerly|energetically|"
      "with enthusiasm|with care|in style|with style|like a gentleman|like a good robot|like a soldier|like a butler|"
      "in greeting|in farewell|as a greeting|as a sign of respect|respectfully|for good measure|for fun|for practice|"
      "for a change|to your heart's content|for a while|for a bit|for a moment|for a sec|for now|as far as you can go|"
      "shall|please please|some more|again "
      "for|level|position|pose|stance|posture|pace|yourselves|everybody|people|folks|"
      "guys|ladies|gentlemen|kids|children|guests|class|team|judges|photographer|teacher|camera|friends|family|mum|dad|"
      "grandma|new|other|same|whole|top|bottom|end|front",
      M::kFiller);
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
      "while you do so|while you do that|at once|during that|and at the same time|in the meantime|while "
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
  x.Add("not|and not|but not|instead of|rather than|as opposed to", M::kNot);
  x.Add("don't|do not|dont|actually don't|no don't|do not ever|don't ever", M::kForbid);
  x.Add(
      "never mind|nevermind|scratch that|forget it|forget that|forget about it|cancel that|"
      "strike that|skip that|ignore that|leave it|drop that|cancel|not that|"
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
      "is|are|be|will|as|like|very|nearly|almost|more|further|another|place|spot|on the spot|"
      "in place|ground|floor|period|duration|for a duration of|for a period of|through|off|out|set|depth|a depth of|"
      "to a depth of|at an angle of|an angle of|through an angle of|or so|good|nice|big|little|small|side|direction|"
      "way|low|full|fully|completely|all|again and|politely|friendly|happily|bit|way back|with a|steady|steadily|"
      "own|per|every|worth|count|forth|down to|at a|at about|starting|at speed|speed of|only|then just|"
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
    AddEnglishStairs(x);
    AddEnglishWalking(x);
    AddEnglishActions(x);
    AddLimbsAndAmounts(x);
    AddEnglishAsides(x);
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
