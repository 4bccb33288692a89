// SPDX-License-Identifier: BSD-3-Clause
// The style sheet of a report (page.h).
#pragma once

namespace report {

constexpr const char* page_style = R"(
:root { color-scheme: light; --ink: #1c1c1c; --soft: #5a5a5a; --line: #c8c8c8; }
* { box-sizing: border-box; }
body { margin: 0 auto; padding: 24px; max-width: 190mm; font: 10pt/1.4 system-ui, sans-serif; color: var(--ink);
  background: #fff; }
h1 { font-size: 18pt; margin: 0; } h2 { font-size: 12pt; margin: 16px 0 4px; } p { margin: 2px 0; }
.title { color: var(--soft); margin-bottom: 10px; overflow-wrap: anywhere; }
.about { margin-bottom: 10px; }
.verdict { border-left: 8px solid; padding: 4px 12px; background: #f5f5f5; }
.words { font-size: 16pt; font-weight: 600; }
.verdict.class0 { border-color: #2e8b57; } .verdict.class1 { border-color: #c9a400; }
.verdict.class2 { border-color: #e06c00; } .verdict.class3 { border-color: #b5172c; }
rect.class0 { fill: #9fd3b4; } rect.class1 { fill: #f3dd7c; } rect.class2 { fill: #f5b173; }
rect.class3 { fill: #e58a96; }
svg text { font-family: system-ui, sans-serif; text-anchor: middle; }
.bar text, .legend text { font-size: 10px; fill: var(--ink); }
.bar { margin-top: 6px; } .interval { fill: #1c1c1c66; } .value { stroke: #1c1c1c; stroke-width: 2.5; }
.tick { stroke: #555; }
svg { display: block; width: 100%; }
.compass { display: inline-block; width: 12px; vertical-align: -2px; } .compass path { fill: none; stroke: #1c1c1c;
  stroke-width: 1.6; }
.plan { width: 100%; max-height: 190mm; object-fit: contain; object-position: 0 0; margin-top: 10px; }
.drawings { display: grid; grid-template-columns: 1fr 1fr; gap: 10px; margin-top: 12px; }
.variants { grid-template-columns: repeat(3, 1fr); } .variants img { width: 100%; }
figure { margin: 0; } figcaption, .note { font-size: 8.5pt; color: var(--soft); }
figure path { fill: none; } figure .source { stroke: #ff9d1e; } figure .region { stroke: #36d6ff; }
figure text { paint-order: stroke; stroke: #000b; stroke-width: .28em; font-weight: 600; }
figure text.source { fill: #ffc46b; stroke: #000b; } figure text.region { fill: #9beaff; stroke: #000b; }
table { border-collapse: collapse; width: 100%; }
th { text-align: left; font-weight: 600; color: var(--soft); font-size: 8.5pt; vertical-align: bottom; }
td, th { padding: 2px 8px 2px 0; border-bottom: 1px solid var(--line); vertical-align: top; }
td { overflow-wrap: anywhere; }
tr { break-inside: avoid; } h2 { break-after: avoid; }
.numbers td:nth-child(2) { color: var(--soft); } .numbers td:nth-child(3) { font-weight: 600; }
td, th:first-child { white-space: nowrap; } .numbers td:first-child, .what { white-space: normal; }
.what { width: 38%; }
td data { font-variant-numeric: tabular-nums; white-space: nowrap; }
dl { display: grid; grid-template-columns: max-content 1fr; gap: 4px 12px; margin: 0; }
dt { color: var(--soft); } dd { margin: 0; min-width: 0; }
code { display: block; font: 8pt/1.35 ui-monospace, monospace; overflow-wrap: anywhere; }
.files td, .files th { font-size: 7.5pt; border: 0; padding: 0 8px 0 0; }
.files td:last-child { white-space: normal;  font: 6.5pt/1.5 ui-monospace, monospace; }
@media (max-width: 600px) {
  body { padding: 12px; } .drawings, dl { grid-template-columns: 1fr; } td { white-space: normal; }
  .sources { display: block; overflow-x: auto; }
}
@media print {
  @page { size: A4; margin: 13mm 15mm; }
  * { print-color-adjust: exact; -webkit-print-color-adjust: exact; }
  body { padding: 0; max-width: none; } section + section { break-before: page; }
  .verdict, figure { break-inside: avoid; }
}
)";

}  // namespace report
