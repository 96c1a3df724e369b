// SPDX-License-Identifier: MIT
// Errors of Khronos' glTF validator in files, and its warnings about values outside an enumeration. Reads file names,
// one per line, and prints {file: ["CODE POINTER"]}. NODE_PATH is the folder of the validator.
const fs = require("fs");
const path = require("path");
const validator = require("gltf-validator");

async function errorsOf(file) {
  const read = (uri) => fs.promises.readFile(path.join(path.dirname(file), decodeURIComponent(uri)));
  try {
    const options = { externalResourceFunction: read, maxIssues: 0, writeTimestamp: false };
    const report = await validator.validateBytes(new Uint8Array(fs.readFileSync(file)), options);
    const counts = (one) => one.severity === 0 || one.code === "VALUE_NOT_IN_LIST";
    return report.issues.messages.filter(counts).map((one) => one.code + " " + (one.pointer || ""));
  } catch (error) {
    return [String(error)];
  }
}

(async () => {
  const report = {};
  for (const file of fs.readFileSync(0, "utf8").split("\n").filter((line) => line)) report[file] = await errorsOf(file);
  console.log(JSON.stringify(report));
})();
