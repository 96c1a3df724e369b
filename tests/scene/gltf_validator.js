// SPDX-License-Identifier: MIT
// What the glTF validator of Khronos says of files: prints {file: [codes of its errors]}, warnings of values that no list
// has among them. NODE_PATH says where it is.
const fs = require("fs");
const path = require("path");
const validator = require("gltf-validator");

async function errorsOf(file) {
  const read = (uri) => fs.promises.readFile(path.join(path.dirname(file), decodeURIComponent(uri)));
  try {
    const options = { externalResourceFunction: read, maxIssues: 0, writeTimestamp: false };
    const report = await validator.validateBytes(new Uint8Array(fs.readFileSync(file)), options);
    return report.issues.messages.filter((one) => one.severity === 0 || one.code === "VALUE_NOT_IN_LIST").map((one) => one.code);
  } catch (error) {
    return [String(error)];
  }
}

(async () => {
  const report = {};
  for (const file of process.argv.slice(2)) report[file] = await errorsOf(file);
  console.log(JSON.stringify(report));
})();
