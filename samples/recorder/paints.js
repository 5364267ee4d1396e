// What there is to paint with: the pigments of the library and the built-in brushes, as
// `pentimento list pigments` and `pentimento list brushes` name them (the test compares both).
// The rest of a brush is for the preview only.
(function (R) {
  "use strict";

  // Name, colour over white, colour over black. The first ones are an oil painter's box.
  const pigments = [
    ["Titanium White", "#f7f6f0", "#e0dfd9"],
    ["Naples Yellow", "#f0d58c", "#d9c17e"],
    ["Lemon Yellow", "#f7e03a", "#bdac2a"],
    ["Cadmium Yellow", "#ebc107", "#b49403"],
    ["Yellow Ochre", "#c08a2c", "#a47524"],
    ["Brilliant Orange", "#e37b07", "#0e0e03"],
    ["Cadmium Red", "#e36137", "#a71210"],
    ["Alizarin Crimson", "#8e1429", "#4a0d11"],
    ["Burnt Sienna", "#8a3b1e", "#5f2612"],
    ["Burnt Umber", "#874922", "#3b2d03"],
    ["Viridian", "#1c6b56", "#0d3b2f"],
    ["Chromium Oxide Green", "#5b7a3c", "#526e35"],
    ["Cerulean Blue", "#46c3cf", "#256e84"],
    ["Cobalt Blue", "#1f4fa8", "#14387a"],
    ["French Ultramarine", "#7676f2", "#08084f"],
    ["Prussian Blue", "#14304f", "#0d1526"],
    ["Cobalt Violet", "#7b3f8f", "#542963"],
    ["Ivory Black", "#1d1b1a", "#1b1918"],
    ["Quinacridone Rose", "#d2419a", "#370324"],
    ["Indian Red", "#be7957", "#aa6345"],
    ["Hooker's Green", "#399437", "#0a1403"],
    ["Hansa Yellow", "#f2d831", "#98a908"],
    ["Phthalo Green", "#3da992", "#0a3126"],
    ["Interference Lilac", "#efe8f1", "#bf8ec5"],
    ["Zinc White", "#f6f6f3", "#b5b5b3"],
    ["Raw Sienna", "#a86b2a", "#74491a"],
    ["Raw Umber", "#5e4630", "#493624"],
    ["Vermilion", "#d8361f", "#c4301b"],
    ["Ultramarine Blue", "#26309a", "#151c65"],
    ["Golden Bone Black", "#1e2023", "#1e1f21"],
    ["Golden Hansa Yellow Opaque", "#ffe216", "#9da70d"],
    ["Golden Diarylide Yellow", "#ffb316", "#ac8f0d"],
    ["Golden Cadmium Orange", "#ff7116", "#bb690d"],
    ["Golden Pyrrole Orange", "#ff4616", "#b3440d"],
    ["Golden Cadmium Red Light", "#ec2716", "#be270d"],
    ["Golden Pyrrole Red", "#cb1616", "#a60d0d"],
    ["Golden Quinacridone Red", "#c51632", "#77152e"],
    ["Golden Quinacridone Magenta", "#a3163d", "#5d1532"],
    ["Golden Dioxazine Purple", "#2b2121", "#2b211f"],
    ["Golden Ultramarine Blue", "#2616d4", "#110e2c"],
    ["Golden Cobalt Blue", "#164aeb", "#153366"],
    ["Golden Cerulean Blue Chromium", "#1676d9", "#154464"],
    ["Golden Phthalo Blue Red Shade", "#16167b", "#15142e"],
    ["Golden Phthalo Blue Green Shade", "#16167e", "#151340"],
    ["Golden Phthalo Green Blue Shade", "#163c37", "#0d2531"],
    ["Golden Phthalo Green Yellow Shade", "#16933b", "#0d2329"],
    ["Golden Bismuth Vanadate Yellow", "#fffa16", "#c8be15"],
    ["Golden Titanium White", "#fffffd", "#e8e8e7"]
  ].map(([name, overWhite, overBlack]) => ({ name, overWhite, overBlack }));

  // count: bristles of the preview; mark: the width of a bristle's mark, in diameters; tip: a disc,
  // or an edge across the stroke; wide: of the disc, of the diameter. sizePressure, flowPressure, capacity: as in the log's format.
  const brushes = {
    round: { count: 60, mark: 0.07, tip: "disc", sizePressure: 0.4, flowPressure: 0.7, capacity: 400, lays: true },
    flat: { count: 50, mark: 0.06, tip: "edge", sizePressure: 0.12, flowPressure: 0.7, capacity: 400, lays: true },
    filbert: { count: 46, mark: 0.06, tip: "edge", sizePressure: 0.25, flowPressure: 0.7, capacity: 400, lays: true },
    bristle: { count: 28, mark: 0.038, tip: "edge", sizePressure: 0.2, flowPressure: 0.7, capacity: 240, lays: true },
    fan: { count: 11, mark: 0.04, tip: "edge", sizePressure: 0.1, flowPressure: 0.6, capacity: 120, lays: true },
    rigger: { count: 8, mark: 0.1, tip: "disc", wide: 0.28, sizePressure: 0.5, flowPressure: 0.5, capacity: 1000, lays: true },
    knife: { count: 60, mark: 0.06, tip: "edge", sizePressure: 0, flowPressure: 0.5, capacity: 200, lays: false },
    rag: { count: 70, mark: 0.08, tip: "disc", sizePressure: 0.2, flowPressure: 1, capacity: 200, lays: false }
  };

  R.paints = { pigments, brushes, boxSize: 18 };
})((window.Recorder = window.Recorder || {}));
