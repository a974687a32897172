// SPDX-License-Identifier: BSD-3-Clause
#include "playback/report/page_style.h"

namespace gaitwright {

std::string PageStyle() {
  return R"(
:root{--paper:#fff;--sheet:#f5f7f9;--ink:#1f2730;--soft:#56616d;--rule:#dde2e7;--pass:#00785a;--fail:#b3164f;--bar:#7a9ab0;
color-scheme:light dark}
@media (prefers-color-scheme:dark){:root{--paper:#14181d;--sheet:#1b2128;--ink:#dfe5ec;--soft:#a3adb8;--rule:#303942;
--pass:#2fd0a2;--fail:#ff6f9f;--bar:#6f8fa8}}
*{box-sizing:border-box}
body{margin:0;background:var(--paper);color:var(--ink);font:15px/1.5 system-ui,'Segoe UI',Roboto,'Helvetica Neue',Arial,sans-serif}
main{max-width:1040px;margin:0 auto;padding:28px 24px 48px}
h1{font-size:26px;line-height:1.25;margin:0;font-weight:650}
h2{font-size:18px;margin:40px 0 10px;font-weight:650}
p{margin:6px 0}
.soft{color:var(--soft)}
.head{display:flex;gap:18px;align-items:center;flex-wrap:wrap}
.verdict{font-weight:700;font-size:20px;letter-spacing:.06em;padding:6px 16px;border-radius:8px;border:2px solid}
.verdict.pass{color:var(--pass)}
.verdict.fail{color:var(--fail)}
.score{margin-left:auto;text-align:right}
.score b{font-size:30px;font-weight:650;font-variant-numeric:tabular-nums}
.reason{margin:16px 0 0;padding:12px 16px;background:var(--sheet);border-left:4px solid var(--bar);border-radius:0 6px 6px 0}
.reason.fail{border-color:var(--fail)}
.reason.pass{border-color:var(--pass)}
.cards{display:grid;grid-template-columns:repeat(auto-fit,minmax(146px,1fr));gap:12px;margin:20px 0 0}
.card{background:var(--sheet);border-radius:8px;padding:12px 14px}
.card .what{color:var(--soft);font-size:13px;line-height:1.3;min-height:2.6em}
.card .figure{font-size:22px;font-weight:650;font-variant-numeric:tabular-nums;margin:2px 0}
.card .figure.fail{color:var(--fail)}
.card .limit{color:var(--soft);font-size:12.5px}
.use{height:5px;border-radius:3px;background:var(--rule);margin:6px 0 4px;overflow:hidden}
.use i{display:block;height:100%;background:var(--bar)}
.use i.fail{background:var(--fail)}
figure{margin:18px 0 26px}
figure svg{width:100%;height:auto;display:block}
.narrow{max-width:420px}
figcaption{color:var(--soft);font-size:13.5px;max-width:78ch;margin-top:4px}
.scroll{overflow-x:auto}
table{border-collapse:collapse;width:100%;font-size:13.5px}
th,td{text-align:left;padding:5px 10px 5px 0;border-bottom:1px solid var(--rule);vertical-align:top}
th{color:var(--soft);font-weight:600;white-space:nowrap}
td.n,th.n{text-align:right;font-variant-numeric:tabular-nums;white-space:nowrap}
td .key{font-family:ui-monospace,SFMono-Regular,Menlo,Consolas,monospace;font-size:12.5px}
td .meaning{color:var(--soft);font-size:12.5px;display:block}
tr.group td{font-weight:650;padding-top:16px;border-bottom:2px solid var(--rule)}
.mark{font-weight:700;white-space:nowrap}
.mark.pass{color:var(--pass)}
.mark.fail{color:var(--fail)}
ul{margin:6px 0;padding-left:20px}
details{margin-top:12px}
summary{cursor:pointer;color:var(--soft)}
details table{font-size:12.5px}
@media print{main{max-width:none;padding:0}figure,.card,tr{break-inside:avoid}h2{break-after:avoid}h2.screen{display:none}}
)";
}

}  // namespace gaitwright
