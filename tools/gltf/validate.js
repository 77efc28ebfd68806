// SPDX-License-Identifier: LGPL-2.1-or-later
// node validate.js PACKAGES FILE...   what Khronos' glTF validator says of each file, as one JSON list
"use strict";
const fs = require("fs");
const path = require("path");
const [packages, ...files] = process.argv.slice(2);
const validator = require(path.resolve(packages, "gltf-validator"));

Promise.all(files.map((file) => validator.validateBytes(new Uint8Array(fs.readFileSync(file)))))
  .then((reports) => console.log(JSON.stringify(reports)))
  .catch((reason) => {
    console.error(String(reason));
    process.exitCode = 1;
  });
