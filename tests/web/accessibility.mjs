// SPDX-License-Identifier: MIT
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { eventually } from "./timeouts.mjs";

const require = createRequire(`${process.env.HEDGEHOG_NODE_MODULES}/`);
const kAxe = readFileSync(require.resolve("axe-core/axe.min.js"), "utf8");

/** What axe finds of serious or critical impact on a page: pairs of a rule and the first element that breaks it. The page is checked
 * while its connection is open: without telemetry for two seconds, as on a busy machine, its values are dimmed below the contrast
 * that text needs, and a banner says that they are out of date. */
export async function seriousFaults(page) {
  // Loaded as text, because the pages' policy allows no foreign scripts.
  await page.evaluate(kAxe);
  let faults;
  await eventually(async () => (faults = await page.evaluate(check)));
  return faults;
}

/** In the page. Returns nothing if the connection was not open from beginning to end. */
async function check() {
  const open = () => document.body.dataset.link === "open";
  if (!open()) return undefined;
  let wasOpen = true;
  const watch = new MutationObserver(() => { wasOpen &&= open(); });
  watch.observe(document.body, { attributeFilter: ["data-link"] });
  const { violations } = await window.axe.run();
  watch.disconnect();
  if (!wasOpen) return undefined;
  return violations.filter(({ impact }) => ["serious", "critical"].includes(impact)).map(({ id, nodes }) => [id, nodes[0].html]);
}
