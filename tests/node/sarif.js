// Validates SARIF documents against the schema of SARIF 2.1.0: node sarif.js SCHEMA FILE… prints a line of JSON for each, with what is
// wrong with it.
import fs from 'node:fs';
import Ajv from 'ajv';
import formats from 'ajv-formats';

const [schema, ...files] = process.argv.slice(2);
const ajv = new Ajv({ strict: false, allErrors: true, unicodeRegExp: false });
formats(ajv);
const validate = ajv.compile(JSON.parse(fs.readFileSync(schema)));
for (const file of files) {
    const isValid = validate(JSON.parse(fs.readFileSync(file)));
    console.log(JSON.stringify(isValid ? [] : validate.errors.map(({ instancePath, message }) => `${instancePath} ${message}`)));
}
