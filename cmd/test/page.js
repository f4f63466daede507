// SPDX-License-Identifier: MIT
// Runs README's examples in the page, and what a reader does there, in a Chromium
// without a window, to which this speaks the DevTools protocol through a pipe.
// usage: node page.js PAGE [PICTURES], a folder for pictures of the page
'use strict';
const { spawn } = require('child_process');
const fs = require('fs');
const os = require('os');
const path = require('path');

const [page, pictures] = process.argv.slice(2).map(f => path.resolve(f));
const profile = fs.mkdtempSync(path.join(os.tmpdir(), 'page'));
const browser = spawn('chromium', ['--headless', '--remote-debugging-pipe',
	'--disable-gpu', '--no-first-run', '--disable-background-networking',
	'--disable-component-update', '--disable-dev-shm-usage', '--disable-sync',
	'--disable-quic', `--user-data-dir=${profile}`,
	...(process.getuid() === 0 ? ['--no-sandbox'] : [])],
	{ stdio: ['ignore', 'ignore', 'ignore', 'pipe', 'pipe'] });
const waiting = new Map(), fetched = [], thrown = [];
let session, count = 0, heard = '';

function hear({ id, result, error, method, params }) {
	if (id)
		waiting.get(id)(error ?? result);
	else if (method === 'Network.requestWillBeSent')
		fetched.push(params.request.url);
	else if (method === 'Runtime.exceptionThrown')
		thrown.push(params.exceptionDetails.exception?.description ?? method);
}

browser.stdio[4].on('data', data => {
	const parts = (heard + data).split('\0');
	heard = parts.pop();
	parts.forEach(part => hear(JSON.parse(part)));
});

function ask(method, params = {}) {
	const question = { id: ++count, sessionId: session, method, params };
	browser.stdio[3].write(JSON.stringify(question) + '\0');
	return new Promise(done => waiting.set(count, done));
}

// Returns what a script gives in the page.
async function inPage(expression) {
	const said = await ask('Runtime.evaluate',
		{ expression, awaitPromise: true, returnByValue: true });
	if (said.exceptionDetails)
		throw new Error(said.exceptionDetails.exception?.description);
	return said.result.value;
}

let passed = 0, failed = 0;

function check(name, said, want) {
	if (said === want) {
		passed++;
		return;
	}
	failed++;
	console.log(`${name}\nwanted ${JSON.stringify(want)}`);
	console.log(`said   ${JSON.stringify(said)}`);
}

// README's lines of a shell, of which this knows pipes and these commands.
const stage = {
	cat: w => files[w[0]],
	echo: w => w.join(' ') + '\n',
	printf: w => w[0].replace(/\\n/g, '\n'),
	head: (w, input) => input.split(/^/m).slice(0, w[1]).join(''),
	sed: (w, input) => input.split(/^/m)[parseInt(w[1]) - 1],
};
const files = {};
for (const f of fs.readdirSync('testdata').filter(f => f.endsWith('.json')))
	files[`testdata/${f}`] = fs.readFileSync(`testdata/${f}`, 'utf8');

async function shell(line) {
	let text = '';
	const command = /(?:'[^']*'|"(?:\\.|[^"\\])*"|\\[^]|[^|'"\\])+/g;
	for (const part of line.match(command)) {
		const joined = JSON.stringify(part.replace(/\\\n/g, ''));
		const [name, ...args] = await inPage(`words(${joined})`);
		if (name !== 'projcalc') {
			text = stage[name](args, text);
			continue;
		}
		const call = [args, text, files].map(x => JSON.stringify(x));
		const { out, err, status } = await inPage(`run(${call})`);
		text = out + err + (status ? `? ${status}\n` : '');
	}
	return text;
}

// Whether the next line of a shell belongs to this one.
const goesOn = s => /[\\|]\n$/.test(s) || s.split(/['"]/).length % 2 === 0;

async function readme() {
	const text = fs.readFileSync('README.md', 'utf8');
	const examples = [...text.matchAll(/^```\n(.*?)^```/gms)]
		.flatMap(([, block]) => block.split(/^\$ /m).slice(1));
	for (const lines of examples.map(example => example.split(/(?<=\n)/))) {
		let line = lines.shift();
		while (goesOn(line))
			line += lines.shift();
		if (/^(?:.*\| *)?(?:projcalc|cat)\b/s.test(line))
			check(line, await shell(line).catch(String), lines.join(''));
	}
}

// Presses keys in an empty field: those of a text, and another.
async function press(id, text, last) {
	await inPage(`$("${id}").focus(), $("${id}").value = ""`);
	for (const key of [...text, last]) {
		const code = { Enter: 13 }[key], sent = code ? '\r' : key;
		await ask('Input.dispatchKeyEvent', { type: 'keyDown', key, text: sent,
			windowsVirtualKeyCode: code });
		await ask('Input.dispatchKeyEvent', { type: 'keyUp', key });
	}
	await sleep(1000);
}

// Types into a field, as a reader does, and waits until the page has answered.
function type(id, text) {
	return inPage(`$('${id}').value = ${JSON.stringify(text)}; compute()`);
}

const read = id => inPage(`$('${id}').textContent`);
const marked = id => inPage(`$('${id}').previousSibling.querySelector('mark')` +
	'.textContent');
const sleep = ms => new Promise(done => setTimeout(done, ms));

async function faults() {
	await type('call', 'lookat');
	await type('points', '');
	await type('scene', '{\n  "eye": [0, 0, -5],\n  "at": 3\n}');
	check('a fault of the scene', await read('status'), 'exit status 1');
	check('is marked', await marked('scene'), '  "at": 3');
	check('and told', await read('scene-faults'),
		'line 3: /at: is a number; an array of 3 numbers is wanted');
	await inPage('$("scene-faults").firstChild.click()');
	check('where', await inPage('document.activeElement.id + ' +
		'$("scene").value.slice($("scene").selectionStart)'), 'scene3\n}');
	await picture('fault');
	await type('call', 'project');
	await type('scene', files['testdata/scene.json']);
	check('a scene without fault', await read('scene-faults'), '');
	await type('points', '0 0 0 centre\n9 lamp\n');
	check('a bad line', await marked('points'), '9 lamp');
}

async function results() {
	const cells = '[...$("out").querySelectorAll("td")]';
	await type('points', '0 0 0 centre\n9 9 0 lamp\n');
	check('a table', await inPage(`${cells}.map(c => c.textContent).join()`),
		'320,240,0.8888888888888888,centre,' +
		'1068.245948869755,-508.245948869755,0.8888888888888888,lamp');
	await inPage('$("as-text").click()');
	check('as text', (await read('out')).split('\n')[0],
		'320 240 0.8888888888888888 centre');
	await inPage('$("as-text").click()');
	await inPage(`last.out = '<svg xmlns="http://www.w3.org/2000/svg" ' +
		'viewBox="0 0 2 1"><path d="M0 0L2 1"/></svg>'; show()`);
	check('a picture', await inPage(`(async () => {
		const image = $('out').querySelector('img');
		await image.decode();
		return image.naturalWidth / image.naturalHeight;
	})()`), 2);
}

async function pictureExample() {
	check('pictures', await inPage(`(async () => {
		const bad = [];
		for (const name in pictures) {
			await choose(name);
			const image = $('out').querySelector('img');
			await image.decode().catch(e => bad.push(name + e));
		}
		return Object.keys(pictures).length + bad.join();
	})()`), '5');
	await inPage(`choose(Object.keys(pictures)[0])`);
	await picture('teapot');
}

async function longCall() {
	inPage(`$('call').value = 'project -q -i f64 --keep-going {} /dev/urandom';
		$('scene').value = $('points').value = ''; compute()`);
	while (await inPage('$("stop").hidden'))
		await sleep(100);
	check('a long call', await read('status'), 'running …');
	await picture('running');
	await ask('Input.dispatchKeyEvent', { type: 'keyDown', key: 'Escape' });
	await sleep(200);
	check('is stopped', await inPage('$("status").textContent + $("stop").hidden'),
		'stoppedtrue');
	await press('call', 'help pick', 'Enter');
	check('keys type', await inPage('$("call").value'), 'help pick');
	check('and the next one runs', await read('status'), 'exit status 0');
	check('help', (await read('out')).slice(0, 20), 'usage: projcalc pick');
	await type('scene', '{"window":{"left":0,"right":10,"bottom":0,"top":10},' +
		'"device":{"width":100,"height":100}}');
	await type('points', '1 2\n3 4\n');
	await type('call', 'projcalc w2d');
	check('points of two dimensions', await inPage('last.out'), '10 20\n30 40\n');
}

async function reader() {
	const rows = await inPage('$("out").querySelectorAll("tr").length');
	check('the first example', rows, 2);
	check('all examples end well', await inPage(`(async () => {
		const bad = [];
		for (const o of $('examples').options) {
			await choose(o.value);
			if (last.status !== 0)
				bad.push(o.value);
		}
		return bad.join();
	})()`), '');
	await pictureExample();
	await faults();
	await results();
	await longCall();
	await show(400, 'light');
	check('fits into 400 pixels',
		await inPage('document.documentElement.scrollWidth <= 400'), true);
}

async function show(width, scheme) {
	await ask('Emulation.setDeviceMetricsOverride',
		{ width, height: 900, deviceScaleFactor: 1, mobile: false });
	await ask('Emulation.setEmulatedMedia',
		{ features: [{ name: 'prefers-color-scheme', value: scheme }] });
}

// Draws the page in both widths and schemes, if pictures are wanted.
async function picture(name) {
	if (!pictures)
		return;
	fs.mkdirSync(pictures, { recursive: true });
	for (const width of [400, 1200])
		for (const scheme of ['light', 'dark']) {
			await show(width, scheme);
			const { data } = await ask('Page.captureScreenshot',
				{ captureBeyondViewport: true });
			fs.writeFileSync(`${pictures}/${name}-${width}-${scheme}.png`,
				Buffer.from(data, 'base64'));
		}
}

async function main() {
	const { targetId } = await ask('Target.createTarget', { url: 'about:blank' });
	const { sessionId } = await ask('Target.attachToTarget',
		{ targetId, flatten: true });
	session = sessionId;
	for (const domain of ['Page', 'Network', 'Runtime'])
		await ask(`${domain}.enable`);
	await ask('Page.navigate', { url: `file://${page}` });
	while (!await inPage('typeof ready').then(t => t === 'object', () => false))
		await sleep(50);
	await inPage('ready');
	await picture('first');
	await readme();
	await reader();
	const sent = fetched.filter(url => !/^(file|blob|data):/.test(url));
	check('sends nothing', sent.join(), '');
	check('throws nothing', thrown.join(), '');
	console.log(`${passed} passed, ${failed} failed`);
}

const late = setTimeout(() => {
	console.log('the page has not answered for two minutes');
	process.exitCode = 1;
	browser.kill();
}, 120000);
main().catch(e => {
	console.log(e);
	failed++;
}).finally(() => {
	clearTimeout(late);
	process.exitCode = failed > 0 ? 1 : 0;
	browser.kill();
});
browser.on('exit', () => fs.rmSync(profile, { recursive: true, force: true }));
