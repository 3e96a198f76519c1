// SPDX-License-Identifier: MIT
/* Words of the page whose contrast is below WCAG's AA, as a person sees them now: evaluated there. */
(() => {
    const rgb = text => (text.match(/[\d.]+/g) ?? []).map(Number);
    const linear = x => (x /= 255) <= 0.04045 ? x / 12.92 : ((x + 0.055) / 1.055) ** 2.4;
    const luminance = ([r, g, b]) => 0.2126 * linear(r) + 0.7152 * linear(g) + 0.0722 * linear(b);

    function groundOf(element) {
        for (let at = element; at; at = at.parentElement) {
            const colour = rgb(getComputedStyle(at).backgroundColor);
            if (colour.length === 3 || colour[3] > 0)
                return colour;
        }
        return [255, 255, 255];
    }

    const words = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT), low = [];
    let count = 0;
    for (let text; (text = words.nextNode());) {
        const element = text.parentElement, style = getComputedStyle(element);
        const hidden = element.closest('[aria-hidden=true], script, style, noscript, option');
        if (!text.data.trim() || hidden || !element.checkVisibility())
            continue;
        const pair = [luminance(rgb(style.color)), luminance(groundOf(element))].sort((a, b) => b - a);
        const contrast = (pair[0] + 0.05) / (pair[1] + 0.05), size = parseFloat(style.fontSize);
        const large = size >= 24 || (size >= 18.66 && style.fontWeight >= 700);
        count++;
        if (contrast < (large ? 3 : 4.5))
            low.push(`${text.data.trim().slice(0, 30)}: ${contrast.toFixed(2)}`);
    }
    /* Edges of what can be operated, and colours that mean something beside each other. */
    for (const element of document.querySelectorAll('button, select, input, textarea')) {
        const style = getComputedStyle(element), own = rgb(style.borderTopColor);
        const drawn = element.checkVisibility() && style.borderTopStyle !== 'none' && own[3] !== 0;
        const pair = [luminance(own), luminance(groundOf(element.parentElement))].sort((a, b) => b - a);
        if (drawn && !['range', 'checkbox'].includes(element.type) &&
            (pair[0] + 0.05) / (pair[1] + 0.05) < 3)
            low.push(`the edge of ${element.id || element.textContent}`);
    }
    return { count, low };
})()
