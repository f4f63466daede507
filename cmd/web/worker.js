// SPDX-License-Identifier: MIT
// Runs a call of the program for the page, behind Emscripten's glue.
const OUTPUT_MAX = 1 << 24; // bytes that are kept; what follows is counted only

function sink() {
	let bytes = new Uint8Array(4096), n = 0;
	return {
		put(c) {
			if (n < OUTPUT_MAX) {
				if (n === bytes.length) {
					const longer = new Uint8Array(2 * n);
					longer.set(bytes);
					bytes = longer;
				}
				bytes[n] = c;
			}
			n++;
		},
		said: () => ({ bytes: bytes.slice(0, n), n }),
	};
}

// data has the words of the call, the bytes of standard input, files by name.
onmessage = async ({ data }) => {
	const out = sink(), err = sink();
	let at = 0, status;
	try {
		const program = await projcalc({
			stdin: () => at < data.input.length ? data.input[at++] : null,
			stdout: out.put,
			stderr: err.put,
			thisProgram: 'projcalc',
			instantiateWasm(imports, done) {
				WebAssembly.instantiate(data.module, imports)
					.then(done);
				return {};
			},
		});
		for (const name in data.files) {
			program.FS.mkdirTree('/' + name.replace(/[^/]*$/, ''));
			program.FS.writeFile(name, data.files[name]);
		}
		status = program.callMain(data.words);
	} catch (e) { // the memory has come to its end
		for (const c of new TextEncoder().encode(`projcalc: ${e.message}\n`))
			err.put(c);
		status = 70;
	}
	postMessage({ out: out.said(), err: err.said(), status });
};
