/* How the page looks: light, dark, on a phone and on paper. */
#include "report_parts.h"

/* A colour pair for each class of a heat cell has a contrast of at least 4.5 (test_report.py). */
static const char *const style[] = {
    ":root{color-scheme:light dark;--paper:#ffffff;--ink:#1b1f23;--soft:#57606a;--rule:#d0d7de;"
    "--shade:#f4f6f8;--tier:#0b5cad;--peer:#a13d00;--hard:#b3541e;"
    "--h1:#fff1d6;--h2:#fdd49e;--h3:#fdae6b;--h4:#ec6b3a;--h5:#a50f15;"
    "--t1:#1b1f23;--t2:#1b1f23;--t3:#1b1f23;--t4:#1b1f23;--t5:#ffffff}\n",
    "@media screen and (prefers-color-scheme:dark){:root{--paper:#14181d;--ink:#e6edf3;"
    "--soft:#9da7b1;--rule:#343c46;--shade:#1d232a;--tier:#6cb6ff;--peer:#ffa657;--hard:#d9793f;"
    "--h1:#33260f;--h2:#543212;--h3:#7d3c10;--h4:#b2431a;--h5:#ff9d7a;"
    "--t1:#f3e8d8;--t2:#f6e6d3;--t3:#ffffff;--t4:#ffffff;--t5:#1b1f23}}\n",
    "*{box-sizing:border-box}\n",
    "body{margin:0 auto;padding:1rem;max-width:74rem;background:var(--paper);color:var(--ink);"
    "font:1rem/1.5 system-ui,'Segoe UI',Roboto,'DejaVu Sans',sans-serif;"
    "overflow-wrap:break-word}\n",
    "h1{font-size:1.7rem;line-height:1.2;margin:.5rem 0}\n",
    "h2{font-size:1.35rem;margin:2.5rem 0 .5rem;border-bottom:1px solid var(--rule);"
    "padding-bottom:.2rem}\n",
    "h3{font-size:1rem;margin:1.4rem 0 .3rem}\n",
    "p{margin:.4rem 0;max-width:62rem}\n",
    "p.soft,figcaption,.key{color:var(--soft);font-size:.875rem}\n",
    "a{color:var(--tier)}\n",
    "nav a{margin-right:.9rem;display:inline-block}.whole{white-space:nowrap}\n",
    "code,pre{font:.85rem/1.45 ui-monospace,'DejaVu Sans Mono',monospace}\n",
    "pre{background:var(--shade);padding:.6rem .8rem;overflow-x:auto;margin:.5rem 0}\n",
    ".columns{display:grid;gap:.5rem 2rem;grid-template-columns:minmax(0,1fr)}\n",
    ".columns>*{min-width:0}\n",
    "@media(min-width:45rem){.two{grid-template-columns:repeat(2,minmax(0,1fr))}}\n",
    "@media(min-width:64rem){.wide{grid-template-columns:minmax(0,3fr) minmax(0,2fr)}}\n",
    ".box{overflow-x:auto;max-width:100%}\n",
    ".box:focus-visible{outline:2px solid var(--tier)}\n",
    "table{border-collapse:collapse;font-size:.875rem;font-variant-numeric:tabular-nums}\n",
    "th,td{padding:.16rem .42rem;text-align:right;white-space:nowrap;font-weight:400}\n",
    "thead th{color:var(--soft);vertical-align:bottom;border-bottom:1px solid var(--rule)}\n",
    "thead th.group{text-align:center;border-left:2px solid var(--paper)}\n",
    "tbody th,thead th:first-child{text-align:left;position:sticky;left:0;"
    "background:var(--paper);z-index:1}\n",
    "tbody tr+tr>*{border-top:1px solid var(--rule)}\n",
    ".heat th,.heat td{padding:.12rem .22rem}\n",
    ".heat tbody td{min-width:2.2rem;border:2px solid var(--paper)}\n",
    ".heat tbody td.cases{color:var(--soft);min-width:0}\n",
    ".trade th{padding:.12rem .3rem}\n",
    ".trade tbody th{max-width:10rem;overflow:hidden;text-overflow:ellipsis}\n",
    ".trade tbody td{padding:.12rem .3rem;border:2px solid var(--paper)}\n",
    ".trade .sum>*{font-weight:600}"
    ".trade tbody tr:not(.sum)+.sum>*{border-top:3px solid var(--rule)}\n",
    "th.turned{height:7.5rem}\n",
    "th.turned span{writing-mode:vertical-rl;transform:rotate(180deg);text-align:left;"
    "color:var(--ink)}\n",
    ".left,thead th.left{text-align:left}\n",
    "dl{display:grid;grid-template-columns:max-content minmax(0,1fr);gap:.1rem .8rem;"
    "font-size:.875rem}dd{margin:0;color:var(--soft)}\n",
    "abbr{text-decoration:none;cursor:help}\n",
    ".key span{display:inline-block;padding:0 .5rem;margin:0 .1rem .2rem 0;min-width:2rem;"
    "text-align:center;border:1px solid var(--rule)}\n",
    ".h0{color:var(--soft)}\n",
    ".h1{background:var(--h1);color:var(--t1)}.h2{background:var(--h2);color:var(--t2)}\n",
    ".h3{background:var(--h3);color:var(--t3)}.h4{background:var(--h4);color:var(--t4)}\n",
    ".h5{background:var(--h5);color:var(--t5)}\n",
    ".h1,.h2,.h3,.h4,.h5{print-color-adjust:exact;-webkit-print-color-adjust:exact}\n",
    "svg{display:block;width:100%;height:auto;font:10.5px system-ui,'Segoe UI',Roboto,"
    "'DejaVu Sans',sans-serif}\n",
    ".plane{max-width:34rem}.histogram{max-width:32rem}\n",
    "svg text{fill:var(--soft)}svg text.name{fill:var(--ink);paint-order:stroke;"
    "stroke:var(--paper);stroke-width:3px;stroke-linejoin:round}\n",
    "svg .grid{stroke:var(--rule);stroke-width:.6;fill:none}\n",
    "svg .none{stroke:var(--soft);stroke-width:.8;stroke-dasharray:3 3}\n",
    "svg .lead{stroke:var(--soft);stroke-width:.6}\n",
    ".tier .dot{fill:var(--tier)}.peer .dot{fill:var(--paper);fill-opacity:.5;stroke:var(--peer);"
    "stroke-width:1.6}\n",
    "svg .tier .name{fill:var(--tier);font-weight:600}svg .peer .name{fill:var(--peer)}\n",
    ".typical{fill:var(--tier)}.hard{fill:var(--hard)}\n",
    "b.typical{color:var(--tier)}b.hard{color:var(--hard)}\n",
    ".pictures{display:grid;gap:.8rem;max-width:62rem}\n",
    "figure{margin:0;display:grid;gap:.3rem;grid-template-columns:repeat(2,minmax(0,1fr));"
    "max-width:26rem}figcaption{grid-column:1/-1}\n",
    "@media(min-width:45rem){.pictures{grid-template-columns:repeat(5,minmax(0,1fr))}"
    "figure{grid-template-columns:minmax(0,1fr);align-content:start}figcaption{min-height:3em}}"
    "\n",
    "img{display:block;width:100%;height:auto;image-rendering:pixelated;background:var(--shade)}\n",
    "@media print{body{padding:0;font-size:9.5pt}section.shape{break-before:page}"
    "h2,h3,h3+p{break-after:avoid}#pictures section{break-inside:avoid}"
    "svg,figure,tr{break-inside:avoid}.box{overflow:visible}nav{display:none}"
    ".heat th,.heat td{padding:.05rem .2rem}.heat tbody td{min-width:2rem}}\n"};

void report_print_style(FILE *out)
{
    fputs("<style>\n", out);
    for (size_t i = 0; i < sizeof style / sizeof *style; i++)
        fputs(style[i], out);
    fputs("</style>\n", out);
}
