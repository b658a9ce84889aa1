// node page_test.mjs [--pictures FOLDER] PAGE...: opens pages of a file each as their readers do, and says what is wrong.
// Each is looked at dark and light, narrow and wide: nothing on the console, no request, no scrolling sideways, axe-core
// content, every picture opened by the keyboard, every link to one too. Of a figure, an SVG by itself, the words.
import { readFileSync } from 'node:fs';
import { basename, dirname, join, resolve } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { chromium } from 'playwright-core';

const here = dirname(fileURLToPath(import.meta.url));
const axe = readFileSync(join(here, 'node_modules/axe-core/axe.min.js'), 'utf8');
const problems = [];
let checks = 0;

function expect(holds, words) {
  ++checks;
  if (!holds) problems.push(words);
}

// Every summary opens and shuts by Enter, and what it opens has a picture with pixels.
async function openPictures(page, at) {
  const summaries = await page.locator('details > summary').all();
  for (const summary of summaries) {
    const name = await summary.innerText();
    const details = summary.locator('..');
    await summary.focus();
    await page.keyboard.press('Enter');
    expect(await details.evaluate((d) => d.open), `${at}: Enter does not open '${name}'`);
    const widths = await details.locator('img').evaluateAll((images) =>
      Promise.all(images.map((image) => image.decode().then(() => image.naturalWidth))));
    expect(widths.length > 0 && widths.every((width) => width > 0), `${at}: a picture of '${name}' is empty`);
    await page.keyboard.press('Enter');
    expect(!(await details.evaluate((d) => d.open)), `${at}: Enter does not shut '${name}'`);
  }
  return summaries.length;
}

// All words of a plot lie within it and beside each other, are large enough to be read, and no paler than axe lets words be.
async function readPlots(page, at) {
  const texts = await page.evaluate(() =>
    [...document.querySelectorAll('svg')].flatMap((svg) => {
      const frame = svg.getBoundingClientRect();
      const light = (element) => {
        const parts = getComputedStyle(element).fill.match(/[\d.]+/g).map((part) => part / 255)
          .map((part) => (part <= 0.04045 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4));
        return 0.05 + 0.2126 * parts[0] + 0.7152 * parts[1] + 0.0722 * parts[2];
      };
      const paper = light(svg.querySelector('rect'));
      return [...svg.querySelectorAll('text')].map((text) => {
        const box = text.getBoundingClientRect();
        const inside = box.left >= frame.left - 1 && box.right <= frame.right + 1 &&
          box.top >= frame.top - 1 && box.bottom <= frame.bottom + 1;
        const contrast = Math.max(light(text) / paper, paper / light(text));
        return { words: text.textContent, inside, contrast, height: Math.min(box.width, box.height),
          left: box.left, right: box.right, top: box.top, bottom: box.bottom };
      });
    }));
  expect(texts.length > 0, `${at}: there is no plot`);
  for (const text of texts) {
    expect(text.inside, `${at}: '${text.words}' is cut off`);
    expect(text.height > 4, `${at}: '${text.words}' is too small`);
    expect(text.contrast > 4.5, `${at}: '${text.words}' is too pale`);
  }
  for (const [i, a] of texts.entries())
    for (const b of texts.slice(0, i))
      expect(Math.min(a.right, b.right) - Math.max(a.left, b.left) < 1 ||
        Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top) < a.height / 3,
        `${at}: '${a.words}' and '${b.words}' lie over each other`);
}

// Links within the page open what they lead to.
async function followLinks(page, at) {
  for (const link of await page.locator('a[href^="#"]').all()) {
    const target = (await link.getAttribute('href')).slice(1);
    await link.focus();
    await page.keyboard.press('Enter');
    const open = await page.evaluate((id) => {
      const found = document.getElementById(id);
      return found !== null && (found.closest('details')?.open ?? true);
    }, target);
    expect(open, `${at}: the link to ${target} does not open it`);
  }
}

async function check(browser, file, colorScheme, width, pictures) {
  const at = `${basename(dirname(file))}/${basename(file)}, ${colorScheme}, ${width} px`;
  const isFigure = file.endsWith('.svg');
  const context = await browser.newContext({ colorScheme, viewport: { width, height: 900 } });
  const page = await context.newPage();
  const url = pathToFileURL(file).href;
  page.on('console', (message) => {
    if (['error', 'warning'].includes(message.type())) problems.push(`${at}: console: ${message.text()}`);
  });
  page.on('pageerror', (error) => problems.push(`${at}: ${error}`));
  page.on('request', (request) => {
    const asked = request.url().split('#')[0];
    if (asked !== url && !asked.startsWith('data:')) problems.push(`${at}: asks for ${asked}`);
  });
  await page.goto(url);
  if (pictures) {
    const name = `${basename(dirname(file))}_${basename(file)}_${colorScheme}_${width}.png`;
    await page.screenshot({ path: join(pictures, name), fullPage: !isFigure });
  }
  const wide = await page.evaluate(() => document.documentElement.scrollWidth - window.innerWidth);
  expect(wide <= 0, `${at}: is ${wide} px wider than the window`);
  await readPlots(page, at);
  const opened = await openPictures(page, at);
  await followLinks(page, at);
  ++checks;
  if (isFigure) {  // axe asks for pages
    await context.close();
    return opened;
  }
  await page.evaluate(axe);
  const found = await page.evaluate(() => window.axe.run());
  for (const violation of found.violations)
    problems.push(`${at}: axe: ${violation.id}: ${violation.help} (${violation.nodes[0].target})`);
  await context.close();
  return opened;
}

const words = process.argv.slice(2);
const pictures = words[0] === '--pictures' ? words.splice(0, 2)[1] : null;
const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
  args: ['--no-sandbox', '--disable-gpu'],
});
let opened = 0;
for (const file of words.map((word) => resolve(word)))
  for (const colorScheme of ['light', 'dark'])
    for (const width of [390, 1280]) opened += await check(browser, file, colorScheme, width, pictures);
await browser.close();
for (const problem of problems) console.error(`FAIL: ${problem}`);
console.log(`${words.length} pages, ${checks} checks, ${opened} pictures opened, ${problems.length} problems`);
process.exit(problems.length === 0 ? 0 : 1);
