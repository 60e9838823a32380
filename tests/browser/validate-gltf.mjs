// Checks glTF files with Khronos' validator: node tests/browser/validate-gltf.mjs FILE...
// Prints errors and warnings; exits 1 if a file has an error, 2 if it was asked wrongly.
import { readFile } from "node:fs/promises";
import validator from "gltf-validator";

const SEVERITY = ["error", "warning"];

async function check(file) {
  const bytes = new Uint8Array(await readFile(file));
  const { issues, info } = await validator.validateBytes(bytes, { uri: file, maxIssues: 1000 });
  for (const { severity, code, message, pointer } of issues.messages) {
    if (severity < SEVERITY.length) console.log(`${file}: ${SEVERITY[severity]} ${code} ${pointer ?? ""}: ${message}`);
  }
  const { numErrors, numWarnings, numInfos, numHints } = issues;
  console.log(
    `${file}: ${numErrors} errors, ${numWarnings} warnings, ${numInfos + numHints} hints; ` +
      `${info?.totalVertexCount ?? 0} vertices, ${info?.totalTriangleCount ?? 0} triangles`,
  );
  return numErrors === 0;
}

const files = process.argv.slice(2);
if (files.length === 0) {
  console.error("usage: node validate-gltf.mjs FILE...");
  process.exit(2);
}
const results = [];
for (const file of files) {
  try {
    results.push(await check(file));
  } catch (error) {
    console.log(`${file}: error ${error}`);
    results.push(false);
  }
}
process.exit(results.every(Boolean) ? 0 : 1);
