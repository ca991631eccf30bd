// SPDX-License-Identifier: MIT
// Runs conformance.json on the JavaScript library in Node.js.
import * as library from "../../../clients/js/src/node.js";
import { addCases } from "./cases.mjs";
import { Driver } from "./driver.mjs";

addCases("JavaScript", () => new Driver(library), (port) => `127.0.0.1:${port}`);
