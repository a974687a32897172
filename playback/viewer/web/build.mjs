// SPDX-License-Identifier: BSD-3-Clause
// node build.mjs OUT.cc: bundles src/main.ts and its dependencies into one script and one style sheet, and writes them
// as the texts that playback/viewer/viewer_bundle_internal.h declares.
import { readdirSync, readFileSync, writeFileSync } from "node:fs";
import { build } from "esbuild";

const kPieceLength = 15000;

/** A C++ literal of any text, split into pieces that every compiler accepts. */
function literal(text) {
  const pieces = [];
  for (let at = 0; at < text.length; at += kPieceLength) pieces.push(`R"gw(${text.slice(at, at + kPieceLength)})gw"`);
  return pieces.join("\n");
}

/** The licences of all packages in the bundle, as a comment. @throws for a package without a licence file. */
function notices(inputs) {
  const folders = Object.keys(inputs).map((file) => /^(.*\bnode_modules\/(?:@[^/]+\/)?[^/]+)\//.exec(file)?.[1]);
  return [...new Set(folders)].filter(Boolean).sort().map((folder) => {
    const licence = readdirSync(folder).find((name) => /^(licen[cs]e|copying)/i.test(name));
    if (!licence) throw new Error(`${folder} has no licence file`);
    const { name, version } = JSON.parse(readFileSync(`${folder}/package.json`, "utf8"));
    return `/*!\n${name} ${version}\n\n${readFileSync(`${folder}/${licence}`, "utf8").replaceAll("*/", "* /").trim()}\n*/\n`;
  }).join("");
}

const result = await build({
  entryPoints: [{ in: "src/main.ts", out: "viewer" }],
  outdir: ".",
  write: false,
  bundle: true,
  minify: true,
  charset: "utf8",
  format: "iife",
  target: ["es2022"],
  legalComments: "none",
  metafile: true,
  logLevel: "warning",
});
const textOf = (ending) => result.outputFiles.find((file) => file.path.endsWith(ending)).text;
const script = notices(result.metafile.inputs) + textOf(".js");
const style = textOf(".css");
for (const text of [script, style]) {
  // A page contains both in CDATA sections within elements.
  if (/\]\]>|<\/(script|style)|\)gw"/i.test(text)) throw new Error("the bundle contains text that would end its element in a page");
}
writeFileSync(
  process.argv[2],
  `// Made by build.mjs.
#include "playback/viewer/viewer_bundle_internal.h"

namespace gaitwright {

std::string_view ViewerScript() {
  return
${literal(script)};
}

std::string_view ViewerStyle() {
  return
${literal(style)};
}

}  // namespace gaitwright
`,
);
