// SPDX-License-Identifier: MIT
/* Chromium without a window, driven over a pipe by its own protocol. */
import { spawn } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

const OPTIONS = ['--headless', '--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run',
                 '--disable-background-networking', '--disable-component-update',
                 '--disable-sync', '--hide-scrollbars', '--remote-debugging-pipe'];

export async function openBrowser(program) {
    const folder = mkdtempSync(join(tmpdir(), 'surehit-page-'));
    const child = spawn(program, [...OPTIONS, `--user-data-dir=${folder}`],
                        { stdio: ['ignore', 'ignore', 'ignore', 'pipe', 'pipe'] });
    const [, , , to, from] = child.stdio, waiting = new Map(), listeners = [];
    let number = 0, rest = '';
    from.setEncoding('utf8').on('data', text => {
        const messages = (rest + text).split('\0');
        rest = messages.pop();
        for (const message of messages.map(JSON.parse)) {
            const { done, failed } = waiting.get(message.id) ?? {};
            waiting.delete(message.id);
            if (message.error)
                failed?.(new Error(JSON.stringify(message.error)));
            else if (done)
                done(message.result);
            else
                listeners.forEach(heard => heard(message));
        }
    });
    const ended = new Promise(done => child.once('exit', done));
    const send = (method, params = {}, sessionId) => new Promise((done, failed) => {
        waiting.set(++number, { done, failed });
        to.write(`${JSON.stringify({ id: number, method, params, sessionId })}\0`);
    });
    return {
        send,
        /* Seconds that pages have computed: what others do on the machine does not count. */
        async computed() {
            const { processInfo } = await send('SystemInfo.getProcessInfo');
            return processInfo.filter(one => one.type === 'renderer')
                              .reduce((sum, one) => sum + one.cpuTime, 0);
        },
        listen: heard => listeners.push(heard),
        async close() {
            await send('Browser.close').catch(() => {});
            await ended;
            rmSync(folder, { recursive: true, force: true, maxRetries: 5, retryDelay: 200 });
        },
    };
}

const KEYS = {
    Tab: 9, Enter: 13, ' ': 32, ArrowLeft: 37, ArrowUp: 38, ArrowRight: 39, ArrowDown: 40,
    Home: 36, End: 35,
};

/* A page of it: what it complains of is kept. */
export async function openPage(browser, { width, height = 900, dark = false }) {
    const { targetId } = await browser.send('Target.createTarget', { url: 'about:blank' });
    const { sessionId } = await browser.send('Target.attachToTarget', { targetId, flatten: true });
    const send = (method, params) => browser.send(method, params, sessionId);
    const complaints = [], asked = [];
    browser.listen(({ method, params, sessionId: of }) => {
        if (of !== sessionId)
            return;
        if (method === 'Runtime.exceptionThrown')
            complaints.push(params.exceptionDetails.exception?.description ?? 'exception');
        if (method === 'Runtime.consoleAPICalled' && ['error', 'warning'].includes(params.type))
            complaints.push(params.args.map(arg => arg.value).join(' '));
        if (method === 'Log.entryAdded' && params.entry.level !== 'verbose')
            complaints.push(`${params.entry.text} ${params.entry.url ?? ''}`);
        if (method === 'Network.requestWillBeSent')
            asked.push(params.request.url);
    });
    await Promise.all(['Runtime', 'Log', 'Page', 'Network'].map(of => send(`${of}.enable`)));
    await send('Emulation.setDeviceMetricsOverride',
               { width, height, deviceScaleFactor: 1, mobile: width < 600 });
    await send('Emulation.setEmulatedMedia', { features: [
        { name: 'prefers-color-scheme', value: dark ? 'dark' : 'light' }] });

    async function evaluate(expression) {
        const { result, exceptionDetails } = await send('Runtime.evaluate', {
            expression, awaitPromise: true, returnByValue: true });
        if (exceptionDetails)
            throw new Error(exceptionDetails.exception?.description ?? exceptionDetails.text);
        return result.value;
    }

    return {
        complaints, asked, send, evaluate,
        go: url => send('Page.navigate', { url }),
        /* Until an expression is true. */
        async until(expression, seconds = 120) {
            for (const end = Date.now() + 1000 * seconds; Date.now() < end;) {
                if (await evaluate(expression).catch(() => false))
                    return;
                await new Promise(done => setTimeout(done, 20));
            }
            throw new Error(`in ${seconds} seconds it did not come true: ${expression}`);
        },
        async press(key, modifiers = 0) {
            const params = { key, code: key, windowsVirtualKeyCode: KEYS[key], modifiers,
                             text: key === 'Enter' ? '\r' : key === ' ' ? ' ' : undefined };
            await send('Input.dispatchKeyEvent', { type: 'keyDown', ...params });
            await send('Input.dispatchKeyEvent', { type: 'keyUp', ...params });
        },
        type: text => send('Input.insertText', { text }),
        async picture(whole = true) {
            const { cssContentSize: size } = await send('Page.getLayoutMetrics');
            const clip = whole ? { x: 0, y: 0, width: size.width, height: size.height, scale: 1 }
                               : undefined;
            const { data } = await send('Page.captureScreenshot',
                                        { clip, captureBeyondViewport: whole });
            return Buffer.from(data, 'base64');
        },
        close: () => browser.send('Target.closeTarget', { targetId }),
    };
}
