//! Names in the encoding that a file says, guesses, or that the caller states.

use encoding_rs::Encoding;
use seamster::config::Limits;
use seamster::fault::Faults;
use seamster::pattern::{ImportOptions, Pattern, TextEncoding, import};
use seamster_fixtures::dxf::DxfBuilder;

/// A back of 490 by 550 mm and a front of other height, in this order, by their names.
fn two_pieces(page: Option<&str>, [back, front]: [&str; 2]) -> String {
    let mut file = DxfBuilder::metric().header("$ACADVER", 1, "AC1009");
    if let Some(page) = page {
        file = file.header("$DWGCODEPAGE", 3, page);
    }
    for (name, height) in [(back, 550.0), (front, 500.0)] {
        let corners = [[0.0, 0.0], [490.0, 0.0], [490.0, height], [0.0, height]];
        file = file
            .block(name)
            .text("1", &format!("Piece Name: {name}"))
            .run("1", true, &corners);
    }
    file.text_of_file()
}

fn read(bytes: &[u8], encoding: Option<&str>) -> Result<Pattern, Faults> {
    let options = ImportOptions {
        encoding: encoding.map(|label| TextEncoding::for_label(label).expect("an encoding")),
        ..ImportOptions::default()
    };
    import(bytes, &options, &Limits::default())
}

/// The names of the panels with their heights [mm], and the warnings.
fn pieces(pattern: &Pattern) -> Vec<(&str, f64)> {
    let panels = pattern.panels.iter();
    let height = |area: f64| (1e6 * area / 490.0).round();
    panels
        .map(|p| (p.name.as_str(), height(p.area_m2)))
        .collect()
}

#[test]
fn names_are_those_of_the_same_file_in_utf8() {
    for (page, label, names) in [
        ("ANSI_1250", "windows-1250", ["TYŁ", "PRZÓD"]),
        ("ANSI_1251", "windows-1251", ["СПИНКА", "ПЕРЕД"]),
        ("windows-1251", "windows-1251", ["СПИНКА", "ПЕРЕД"]),
        ("cp1251", "windows-1251", ["Спинка", "перед"]),
        ("dos866", "ibm866", ["СПИНКА", "ПЕРЕД"]),
        ("KOI8-R", "koi8-r", ["СПИНКА", "ПЕРЕД"]),
        ("ANSI_1253", "windows-1253", ["ΠΛΑΤΗ", "ΕΜΠΡΟΣ"]),
        ("ANSI_1254", "windows-1254", ["ARKA İÇ", "ÖN BEDEN ŞIK"]),
        ("ANSI_1255", "windows-1255", ["גב", "חזית"]),
        ("ANSI_1256", "windows-1256", ["خلف", "أمام"]),
        ("ANSI_874", "windows-874", ["หลัง", "หน้า"]),
        ("8859_2", "iso-8859-2", ["TYŁ", "PRZÓD"]),
        ("ANSI_932", "shift_jis", ["後身頃", "前身頃"]),
        ("ANSI_932", "shift_jis", ["ｳｼﾛ", "ﾏｴ"]),
        ("ansi_936", "gbk", ["后片", "前片"]),
        ("ANSI_949", "euc-kr", ["뒤판", "앞판"]),
        ("big5", "big5", ["後片", "前片"]),
        ("MACINTOSH", "macintosh", ["Rücken", "Été"]),
    ] {
        let text = two_pieces(Some(page), names);
        let encoding = Encoding::for_label(label.as_bytes()).expect("a label");
        let (bytes, _, lost) = encoding.encode(&text);
        assert!(!lost, "{page}");
        let pattern = read(&bytes, None).expect("a pattern");
        assert_eq!(
            pieces(&pattern),
            [(names[0], 550.0), (names[1], 500.0)],
            "{page}"
        );
        assert_eq!(pattern.warnings, [], "{page}");
        let twin = read(two_pieces(Some("UTF-8"), names).as_bytes(), None).expect("a pattern");
        assert_eq!(pattern.panels, twin.panels, "{page}");
    }
}

#[test]
fn pages_of_dos_without_a_standard_are_read() {
    let text = two_pieces(Some("DOS850"), ["Ru:cken", "A:rmel"]);
    let bytes: Vec<u8> = text
        .replace("u:", "\u{1}")
        .replace("A:", "\u{2}")
        .bytes()
        .map(|b| match b {
            1 => 0x81,
            2 => 0x8e,
            _ => b,
        })
        .collect();
    let pattern = read(&bytes, None).expect("a pattern");
    assert_eq!(pieces(&pattern), [("Rücken", 550.0), ("Ärmel", 500.0)]);
}

#[test]
fn escapes_are_read_whatever_the_page() {
    let unicode = two_pieces(Some("ANSI_1252"), ["\\U+540E\\U+7247", "\\U+524D\\U+7247"]);
    let pages = two_pieces(
        Some("ANSI_1252"),
        ["\\M+5BAF3\\M+5C6AC", "\\M+5C7B0\\M+5C6AC"],
    );
    for text in [unicode, pages] {
        let pattern = read(text.as_bytes(), None).expect("a pattern");
        assert_eq!(pieces(&pattern), [("后片", 550.0), ("前片", 500.0)]);
        assert_eq!(pattern.warnings, []);
    }
}

#[test]
fn guess_is_told_with_the_alternative_and_the_caller_decides() {
    let names = ["СПИНКА", "ПЕРЕД"];
    for (page, code) in [
        (None, "pattern/encoding_assumed"),
        (Some("ANSI_1361"), "pattern/encoding_unknown"),
    ] {
        let text = two_pieces(page, names);
        let (bytes, ..) = encoding_rs::WINDOWS_1251.encode(&text);
        let guessed = read(&bytes, None).expect("a pattern");
        let warning = &guessed.warnings[0];
        assert_eq!(warning.code, code);
        let offer = "encoding=windows-1251 would make it \"СПИНКА\"";
        assert!(warning.detail.contains(offer), "{}", warning.detail);
        let stated = read(&bytes, Some("cp1251")).expect("a pattern");
        assert_eq!(pieces(&stated), [(names[0], 550.0), (names[1], 500.0)]);
        assert_eq!(stated.warnings, []);
    }
}

#[test]
fn header_that_the_bytes_contradict_is_told() {
    let text = two_pieces(Some("ANSI_1251"), ["СПИНКА", "ПЕРЕД"]);
    let pattern = read(text.as_bytes(), None).expect("a pattern");
    assert_eq!(pieces(&pattern)[0].0, "СПИНКА");
    assert_eq!(pattern.warnings[0].code, "pattern/encoding_conflict");
    assert!(pattern.warnings[0].detail.contains("encoding=windows-1251"));
}
