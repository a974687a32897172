// SPDX-License-Identifier: BSD-3-Clause
// Words that begin what is told beside an instruction, in English and Chinese.
#include "workflows/words/lexicon_internal.h"

namespace gaitwright::words {
namespace {

using M = Meaning;

}  // namespace

void AddEnglishAsides(Lexicon& x) {
  // Conditions, and ways that no robot here goes: nothing that is said with them may be done without them.
  x.Add(
      "if|unless|in case|in the event|provided|as long as|when i|when the|when he|when she|when they|whenever i|"
      "whenever the|on three legs|on two legs|on your hind legs|on hind legs|on all fours|only if|only when|"
      "with your eyes closed|without falling|without touching",
      M::kUnknown);
  // Adverbs that say more than how.
  x.Add(
      "diagonally|obliquely|repeatedly|indefinitely|perpetually|"
      "alternately|alternatingly|randomly|occasionally|partially|partly|blindly|vertically|horizontally|hourly|daily|"
      "separately|respectively|conditionally|secretly|perpendicularly|oppositely|inversely|reversely|doubly|triply",
      M::kUnknown);
  x.Add("he|she|they", M::kSubject, "third");
  x.Add(
      "because|cause|cuz|since|as i|as we|as he|as she|as they|as it|as the|as there|as my|so i|so we|so he|so she|"
      "so they|so the|so my|so that i|so that we|so that he|so that she|so that they|so that the|so that my|"
      "so that it|so that everyone|so that everybody|so that people|so that nobody|so that no one|so that there|"
      "where the|where he|where she|where they|where mrs|where mr|where my|where i|where we|where it|where "
      "everyone|where your|"
      "you've been|you have been|it's gonna|its gonna|its going to|it's going to|it is going to|i'm gonna|we're gonna|"
      "mommy is|mom is|daddy is|dad is|mum is|mummy is|grandma is|grandpa is|like my|like the|like our|like your|just "
      "like|"
      "who has|who have|who is|who are|who was|who were|who's|who came|who will|who wants|who want|that has been|"
      "so everyone|so everybody|so people|so nobody|so no one|so it|so there|in order that|which|whose|although|though|"
      "even though|now that|seeing as|seeing that|given that|considering|or else|otherwise|there's|there is|"
      "there are|that way i|that way we|it's just that|the reason is|for the sake of|thanks to|despite",
      M::kAside);
  x.Add(
      "i|we|he|she|they|i'm|i am|i've|i have|i was|we're|we are|we've|we have|he's|she's|they're|it's|it is|you've "
      "been|"
      "you have been|you look|you seem|you are|you're|you were|everyone is|everybody is|someone is|somebody is|someone|"
      "somebody|everyone's|everybody's|nobody|people are|it has|it was|that's|that is|this is|my legs are|my back is|"
      "the floor is|the nurse",
      M::kSubject);
  x.Add(
      "i'll|we'll|they'll|he'll|she'll|it'll|our|for the|for our|for my|for this|for today's|for your|time for|it's "
      "time for|"
      "i can't|we can't|i could|we could|he has|she has|they have|everyone wants|everybody wants|the whole",
      M::kSubject);
  x.Add("is|are|was|were|has|have|had", M::kFiller, "finite");
  x.Add("one|ones", M::kFiller, "one");
}

void AddChineseAsides(Lexicon& x) {
  x.Add(
      "如果|要是|假如|假使|若|若是|倘若|倘使|一旦|直到|除非|每当|等到|只要|万一|用三条腿|三条腿|用两条腿走|用后腿|"
      "闭着眼|闭着眼睛|"
      "闭上眼睛",
      M::kUnknown);
  x.Add("他|她|它|他们|她们", M::kSubject, "third");
  x.Add(
      "让大家看看你的|让我看看你的|给大家看看你的|给我看看你的|让我们看看你的|让大家看看|有人|我去|我来|我先|我得|我还|"
      "我在|我给你|我帮你|我是|我叫|我这就|我马上|我怕|我好|我再|等我把|等我先|等我弄|看看你的|看看我的|看一看你的|"
      "瞧瞧你的|瞧瞧|看看这|看清楚你|"
      "因为|由于|毕竟|虽然|虽说|尽管|既然|趁|趁着|为了|以便|好让|省得|免得|以免|不然|否则|要不然|不然的话|这样我|"
      "这样大家|"
      "这样后面|这样才|这样就能|这样就可以|这样他|这样她|这样孩子|这样观众|这样老师|这样就不会|好给|方便我|方便大家|"
      "方便他|"
      "让我能|让他们|让他|让她|让孩子|让后面|让镜头|让摄像|谁让|谁叫|怪不得|反正|就当",
      M::kAside);
  x.Add(
      "我|我们|咱|咱们|他|她|它|他们|她们|谁|妈妈|爸爸|爷爷|奶奶|外婆|外公|阿公|阿嬷|阿姨|叔叔|哥哥|姐姐|姊姊|"
      "弟弟|妹妹|老师|教练|护士|医生|校长|老板|领导|导演|摄影师|同学|大家|观众|客人|贵宾|嘉宾|小朋友|孩子|孩子们|宝宝|"
      "地上|地面|地板|地|上面|下面|前面有|后面有|左边有|右边有|旁边有|你左边有|你右边有|你前面有|你后面有|你面前|这边|"
      "那边有|"
      "外面|门口有|时间|天|电话|车|床|你太|你真|你看|你都|你已经|真|太|好热|你这样|听说|看起来|看样子",
      M::kSubject);
}

}  // namespace gaitwright::words
