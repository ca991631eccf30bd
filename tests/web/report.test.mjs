// SPDX-License-Identifier: MIT
// The reports of hedgehog-study and hedgehog-design on a phone: content wider than the screen scrolls in its own box.
import assert from "node:assert/strict";
import { execFile } from "node:child_process";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { promisify } from "node:util";

import { kPhone, launch } from "./browser.mjs";
import { Daemon } from "./daemon.mjs";

const run = promisify(execFile);
const kSmallPhone = { ...kPhone, viewport: { width: 360, height: 640 } };
let browser;
let folder;

before(async () => {
  browser = await launch();
  folder = mkdtempSync(join(tmpdir(), "hedgehog-report-"));
});
after(async () => {
  await browser?.close();
  rmSync(folder, { recursive: true, force: true });
});

/** Elements that overflow the page `file`, and whether its text is as large as on a desktop. */
async function look(file) {
  const page = await (await browser.newContext(kSmallPhone)).newPage();
  await page.goto(`file://${file}`);
  const found = await page.evaluate(() => {
    const inBox = (element) => element.closest(".wide") !== null && !element.matches(".wide");
    const out = [...document.querySelectorAll("body *")]
      .filter((element) => !inBox(element) && element.getBoundingClientRect().right > document.documentElement.clientWidth + 0.5)
      .map((element) => `${element.tagName} ${element.textContent.trim().slice(0, 40)}`);
    return { out, width: document.documentElement.scrollWidth, tables: document.querySelectorAll("table").length };
  });
  await page.context().close();
  return found;
}

test("the designer's report fits a phone", async () => {
  const file = join(folder, "design.html");
  await run(process.env.HEDGEHOG_DESIGN, ["report", "--array", "cD", "--output", file], { cwd: folder });
  const { out, width, tables } = await look(file);
  assert.deepEqual(out, []);
  assert.equal(width, 360);
  assert.ok(tables >= 4, `${tables} tables`);
});

test("a study's report fits a phone", async () => {
  writeFileSync(join(folder, "quick.json"), JSON.stringify({
    name: "quick", task: "two_intervals", level: "current_percent", question: "Which one was stronger?", start: 100, ceiling: 200,
    stages: [{ step_up: 20, reversals: 4 }], step_ratio: 0.5488, duration_ms: 300, gap_ms: 200, practice: 1,
  }));
  const daemon = await Daemon.start({ speed: 100 });
  const env = { ...process.env, HEDGEHOG_ADDRESS: `127.0.0.1:${daemon.tcp}`, HEDGEHOG_PATIENCE_MS: "60000" };
  const study = (...words) => run(process.env.HEDGEHOG_STUDY, words, { cwd: folder, env });
  try {
    await study("plan", "th", "--participants", "2", "--experiments", "quick.json");
    await study("-C", "th", "rehearse");
    await study("-C", "th", "exclude", "P01", "quick", "--reason", "a door slammed in the corridor");
    await study("-C", "th", "analyse");
  } finally {
    await daemon.end();
  }
  const { out, width, tables } = await look(join(folder, "th/analysis/report.html"));
  assert.deepEqual(out, []);
  assert.equal(width, 360);
  assert.ok(tables >= 4, `${tables} tables`);
});
