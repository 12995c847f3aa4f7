//! The style sheet of a drawing.

/// The rules for every class, in the CSS that browsers, Inkscape and resvg share: single classes, no nesting, no
/// variables. Lengths are metres of the building; thickness and lettering that differ from one element to the next
/// are attributes, which any rule added here overrides.
pub const RULES: &str = "
.paper { fill: #ffffff }
.grid { image-rendering: pixelated }
.room { stroke: none }
.partial { fill-opacity: 0.55 }
.fill-0 { fill: #cfe2f3 }
.fill-1 { fill: #fce8c8 }
.fill-2 { fill: #d8ecd1 }
.fill-3 { fill: #f6d7d7 }
.fill-4 { fill: #e3d9f0 }
.fill-5 { fill: #d2eceb }
.fill-6 { fill: #efecc9 }
.wall { fill: none }
.strong { stroke: #222222 }
.medium { stroke: #6b6b6b }
.weak { stroke: #adadad }
.gap { stroke: #ffffff; stroke-linecap: butt }
.jamb { fill: none; stroke: #222222; stroke-width: 0.02 }
.sill { stroke-width: 0.03 }
.door-sill { stroke: #b5530a }
.passage-sill { stroke: #b5530a; stroke-dasharray: 0.12 0.08 }
.frontier { stroke: #1f6fb5; stroke-width: 0.06; stroke-dasharray: 0.25 0.15 }
.leaf { fill: none; stroke: #b5530a; stroke-width: 0.05 }
.swing { fill: none; stroke: #b5530a; stroke-width: 0.015 }
.glass { fill: none; stroke: #222222; stroke-width: 0.015 }
.steps { fill: none; stroke: #6b6b6b; stroke-width: 0.02 }
.symbol-box { fill: none; stroke: #b3123c; stroke-width: 0.03 }
.text { font-family: sans-serif; fill: #8a5a00; text-anchor: middle }
.named { visibility: hidden }
.name { font-family: sans-serif; font-weight: bold; fill: #222222; text-anchor: middle }
.area { font-family: sans-serif; fill: #444444; text-anchor: middle }
.bar { stroke: #222222; stroke-width: 0.02 }
.dark { fill: #222222 }
.light { fill: #ffffff }
.scale-label { font-family: sans-serif; fill: #222222 }
";

/// Further rules when the grid lies underneath: it must show through.
pub const OVER_GRID: &str = "
.room { fill-opacity: 0.5 }
.wall { stroke-opacity: 0.6 }
.gap { stroke-opacity: 0.5 }
";
