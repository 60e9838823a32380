//! Colors of a picture: red, green and blue.

/// Background.
pub(super) const BACKGROUND: [u8; 3] = [250, 249, 247];
/// The body: a warm grey.
pub(super) const BODY: [u8; 3] = [196, 188, 179];
/// Borders of panels.
pub(super) const BORDER: [u8; 3] = [52, 55, 60];
/// Marked places.
pub(super) const MARK: [u8; 3] = [214, 40, 34];

/// Muted colors, those of panels that follow each other unlike in hue.
const PANELS: [[u8; 3]; 12] = [
    [146, 176, 205],
    [214, 158, 132],
    [160, 186, 142],
    [190, 164, 208],
    [212, 188, 122],
    [130, 188, 182],
    [218, 164, 182],
    [172, 158, 122],
    [122, 146, 196],
    [200, 206, 144],
    [156, 142, 178],
    [228, 190, 144],
];
/// Color that the inner side of cloth is mixed with, half and half.
const SHADE: [u8; 3] = [66, 70, 84];

/// Returns the color of the outer side of the panel of this number.
pub(super) fn outer(panel: usize) -> [u8; 3] {
    PANELS[panel % PANELS.len()]
}

/// Returns the color of the inner side of the panel of this number.
pub(super) fn inner(panel: usize) -> [u8; 3] {
    let outer = outer(panel);
    [0, 1, 2].map(|channel| outer[channel].midpoint(SHADE[channel]))
}
