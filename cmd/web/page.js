// SPDX-License-Identifier: MIT
'use strict';
const $ = id => document.getElementById(id);

// Returns what a part of the page holds, zipped and in base64.
function part(id) {
	const zipped = Uint8Array.from(atob($(id).textContent), c => c.charCodeAt(0));
	const unzip = new DecompressionStream('gzip');
	return new Response(new Blob([zipped]).stream().pipeThrough(unzip));
}

const compiled = part('wasm').arrayBuffer().then(b => WebAssembly.compile(b));
const script = URL.createObjectURL(new Blob([$('worker').textContent]));
const SHOWN_MAX = 200000, ROWS_MAX = 1000; // more would make the page slow
const BUSY_AFTER = 300, STOP_AFTER = 2000; // ms

// The worker, and the function that ends the promise of the call that it runs.
let worker = null, finish = null;

function end() {
	if (!finish)
		return;
	worker.terminate();
	worker = null;
	finish({ out: '', err: '', status: null });
	finish = null;
}

const text = ({ bytes, n }) => {
	const s = new TextDecoder().decode(bytes);
	return /[\0\ufffd]/.test(s) ? `(${n} bytes that are no text)\n` : s;
};

// Runs the program with the words of a call, text for its standard input, and files by
// name. Returns its output, messages and status, which is null if the call was ended.
async function run(words, input = '', files = {}) {
	const module = await compiled;
	end();
	worker ??= new Worker(script);
	return new Promise(done => {
		finish = done;
		worker.onmessage = ({ data: { out, err, status } }) => {
			finish = null;
			done({ out: text(out), err: text(err), status });
		};
		input = new TextEncoder().encode(input);
		worker.postMessage({ module, words, input, files });
	});
}

// Splits a line into words as the shell does, with its two kinds of quotes.
function words(line) {
	const parts = /(?:'[^']*'|"(?:\\.|[^"\\])*"|\\.|[^\s'"\\])+/g;
	const quoted = /'([^']*)'|"((?:\\.|[^"\\])*)"|\\(.)/g;
	return (line.match(parts) || []).map(word => word.replace(quoted,
		(_, one, two, c) => one ?? two?.replace(/\\(["\\$`])/g, '$1') ?? c));
}

function element(name, content, props = {}) {
	const e = Object.assign(document.createElement(name), props);
	e.append(...[].concat(content));
	return e;
}

const isNumber = c => c !== '' && (isFinite(c) || /^(nan|na)$/i.test(c));

// Returns the cells of each line if at least half of those of every line are numbers,
// not counting a first line of names; or null.
function cells(out) {
	const comma = /^[^\s,]*,/.test(out), names = comma ? 1 : 0;
	const rows = out.replace(/\n$/, '').split('\n')
		.map(line => comma ? line.split(',') : line.match(/\S+/g) || []);
	const isRow = row => 2 * row.filter(isNumber).length >= row.length;
	return rows.length > names && rows.slice(names).every(isRow) &&
		rows.some(row => row.some(isNumber)) ? rows : null;
}

function table(rows) {
	const cell = c => element('td', c, { className: isNumber(c) ? '' : 'word' });
	const row = r => element('tr', r.length ? r.map(cell) : cell('\u00a0'));
	return element('div', element('table', rows.slice(0, ROWS_MAX).map(row)),
		{ tabIndex: 0 });
}

let last = { out: '', err: '', status: 0 }; // the result that is shown

function show() {
	const { out, err, status } = last, rows = cells(out);
	const isPicture = /^(<\?xml[^>]*>\s*)?<svg/.test(out);
	const asText = $('as-text').ariaPressed === 'true' || !(rows || isPicture);
	const isCut = asText ? out.length > SHOWN_MAX : rows && rows.length > ROWS_MAX;
	const source = 'data:image/svg+xml,' + encodeURIComponent(out);
	$('as-text').hidden = !rows && !isPicture;
	$('out').replaceChildren(
		asText ? element('pre', out.slice(0, SHOWN_MAX), { tabIndex: 0 }) :
			rows ? table(rows) :
				element('img', [], { src: source, alt: 'a picture' }),
		isCut ? element('p', 'There is more output than the page shows.') : '');
	$('out').className = '';
	$('err').textContent = err.slice(0, SHOWN_MAX);
	$('status').textContent = status === null ? 'stopped' : `exit status ${status}`;
	$('status').className = status ? 'bad' : '';
}

// Marks the lines of the scene or the points that messages name.
function mark(id, faults) {
	const area = $(id), lines = area.value.split('\n');
	const bad = new Set(faults.map(f => f.line));
	area.rows = Math.min(Math.max(lines.length + 1, 4), 16);
	const shade = (line, i) => bad.has(i + 1) ? element('mark', line || ' ') : line;
	area.previousSibling.replaceChildren(...lines.slice(0, Math.max(0, ...bad))
		.flatMap((line, i) => [shade(line, i), '\n']));
	area.setAttribute('aria-invalid', faults.length > 0);
	$(id + '-faults').replaceChildren(...faults.slice(0, 10).map(f => {
		const what = [f.reason, f.hint].filter(Boolean).join('; ');
		const told = [`line ${f.line}`, f.pointer, what].filter(Boolean);
		const before = ['', ...lines].slice(0, f.line).join('\n');
		const at = before.length + (f.column || 1) - 1;
		const go = () => area.focus() || area.setSelectionRange(at, at);
		return element('button', told.join(': '),
			{ type: 'button', onclick: go });
	}));
}

// Of messages the places are wanted, so that the call is made again for them.
async function faultsOf([name, ...rest], input, files) {
	const { err } = await run([name, '--errors', 'json', ...rest], input, files);
	return (err.match(/^\{.*"line".*\}$/mg) || []).map(line => JSON.parse(line))
		.filter(f => f.line && f.level === 'error');
}

let turn = 0;

async function compute() {
	const now = ++turn, points = $('points').value;
	const call = words($('call').value.replace(/^\s*projcalc\s/, ''));
	const files = { 'scene.json': $('scene').value }, begun = Date.now();
	const input = /^\s*\[/.test(points) ? '' : points;
	if (call.length > 0 && !/^(help|-.*)$/.test(call[0])) {
		if (files['scene.json'].trim() !== '')
			call.push('scene.json');
		if (input !== points)
			call.push(points);
		else if (points.trim() !== '' && files['scene.json'].trim() !== '')
			call.push('-');
	}
	const timer = setTimeout(() => {
		$('status').textContent = 'running …';
		$('out').className = 'old';
		$('stop').hidden = false;
	}, BUSY_AFTER);
	const said = await run(call, input, files);
	clearTimeout(timer);
	if (now !== turn)
		return;
	$('stop').hidden = true;
	last = said;
	show();
	const faults = said.err && Date.now() - begun < STOP_AFTER ?
		await faultsOf(call, input, files) : [];
	if (now !== turn)
		return;
	mark('scene', faults.filter(f => f.file === 'scene.json'));
	mark('points', faults.filter(f => /^(-|POINTS)$/.test(f.file)));
}

function fill(fields) {
	for (const id of ['call', 'scene', 'points'])
		$(id).value = fields[id];
	return compute();
}

let pictures = {};

// Shows a picture of that name, or a call of the manual, which has its scene and points
// in it.
function choose(example) {
	if (example in pictures)
		return fill(pictures[example]);
	const call = words(example.replace(/^projcalc /, ''));
	const scene = call.find(w => w.startsWith('{'));
	const points = call.find(w => w.startsWith('['));
	const inline = a => a.replace(/\s+/g, ' ').replace(/(?<=\[) | (?=\])/g, '');
	return fill({
		call: call.filter(w => w !== scene && w !== points).join(' '),
		scene: scene ? JSON.stringify(JSON.parse(scene), null, 2)
			.replace(/\[[^[{]*?\]/g, inline) : '',
		points: points ?? '',
	});
}

for (const id of ['call', 'scene', 'points'])
	$(id).oninput = compute;
for (const id of ['scene', 'points'])
	$(id).onscroll = ({ target }) => target.previousSibling.style.transform =
		`translate(${-target.scrollLeft}px, ${-target.scrollTop}px)`;
$('examples').onchange = ({ target }) => choose(target.value);
$('stop').onclick = end;
document.onkeydown = e => void (e.key === 'Escape' && end());
document.forms[0].onsubmit = () => void compute() || false;
$('as-text').onclick = ({ target }) => {
	target.ariaPressed = target.ariaPressed !== 'true';
	show();
};

async function start() {
	const [said, drawn] = await Promise.all([run(['help', '--json']),
		part('pictures').json()]);
	const commands = JSON.parse(said.out).commands
		.map(c => new Option(`${c.name}: ${c.about}`, c.example));
	pictures = Object.fromEntries(drawn.map(p => [p.name, p]));
	$('examples').append(element('optgroup', commands, { label: 'Commands' }),
		element('optgroup', drawn.map(p => new Option(p.name)),
			{ label: 'Pictures' }));
	const first = commands.find(o => /^project:/.test(o.text));
	first.selected = true;
	return choose(first.value);
}

const ready = start();
