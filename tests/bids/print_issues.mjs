// SPDX-License-Identifier: MIT
// print_issues.mjs REPORT: what bids-validator found, a line each. Exit: 0 nothing, 1 an error or a warning.
import { readFileSync } from "node:fs";

const { issues } = JSON.parse(readFileSync(process.argv[2]));
const found = [...issues.errors, ...issues.warnings];
for (const one of found) console.log(one.severity, one.key, one.files.map((file) => file.evidence ?? "").join("; "));
console.log(`bids-validator: ${issues.errors.length} errors, ${issues.warnings.length} warnings`);
process.exit(found.length === 0 ? 0 : 1);
