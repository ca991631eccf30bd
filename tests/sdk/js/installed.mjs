// SPDX-License-Identifier: MIT
// The library as distributed by npm: the file in HEDGEHOG_PACKED, built by pack.sh, installed into an empty folder.
import { execFileSync } from "node:child_process";
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import { fileURLToPath } from "node:url";

const LIBRARY = fileURLToPath(new URL("../../../clients/js", import.meta.url));

function npm(folder, ...args) {
  return execFileSync("npm", [...args, "--no-audit", "--no-fund", "--offline", "--loglevel=error"], { cwd: folder, encoding: "utf8" });
}

/** A new folder with the library in its node_modules. */
export function installed() {
  const folder = fs.realpathSync(fs.mkdtempSync(path.join(os.tmpdir(), "hedgehog-npm-")));
  const game = path.join(folder, "game");
  fs.mkdirSync(game);
  const [file] = fs.readdirSync(process.env.HEDGEHOG_PACKED).filter((name) => name.endsWith(".tgz"));
  npm(game, "install", path.join(process.env.HEDGEHOG_PACKED, file));
  return { folder: game, remove: () => fs.rmSync(folder, { recursive: true }) };
}

/** The first code block in that language in the README. */
export function example(language) {
  return new RegExp(`\`\`\`${language}\\n([\\s\\S]*?)\`\`\``).exec(fs.readFileSync(path.join(LIBRARY, "README.md"), "utf8"))[1];
}
