// Validates glTF files: node validate.js FILE… prints a line of JSON for each, with its issues and totals.
import fs from 'node:fs';
import path from 'node:path';
import validator from 'gltf-validator';

for (const file of process.argv.slice(2)) {
    const folder = path.dirname(file);
    const report = await validator.validateBytes(new Uint8Array(fs.readFileSync(file)), {
        uri: path.basename(file),
        maxIssues: 0,
        externalResourceFunction: async (uri) =>
            new Uint8Array(fs.readFileSync(path.join(folder, decodeURIComponent(uri)))),
    });
    const { totalVertexCount: vertices, totalTriangleCount: triangles } = report.info ?? {};
    const issues = report.issues.messages.map(({ code, severity, pointer, message }) => ({ code, severity, pointer, message }));
    console.log(JSON.stringify({ file, vertices, triangles, issues }));
}
