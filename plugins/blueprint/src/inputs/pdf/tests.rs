use super::*;
use std::f64::consts::FRAC_PI_2;

/// A PDF of these objects, numbered from 1, the first being the catalogue; `trailer` is added to its dictionary.
fn pdf_of(objects: &[String], trailer: &str) -> Vec<u8> {
    let mut bytes = b"%PDF-1.4\n".to_vec();
    let mut offsets = vec![];
    for (i, object) in objects.iter().enumerate() {
        offsets.push(bytes.len());
        bytes.extend(format!("{} 0 obj\n{object}\nendobj\n", i + 1).bytes());
    }
    let start = bytes.len();
    bytes.extend(format!("xref\n0 {}\n0000000000 65535 f \n", objects.len() + 1).bytes());
    offsets.iter().for_each(|o| bytes.extend(format!("{o:010} 00000 n \n").bytes()));
    let size = objects.len() + 1;
    bytes.extend(
        format!("trailer\n<< /Size {size} /Root 1 0 R {trailer} >>\nstartxref\n{start}\n%%EOF\n").bytes(),
    );
    bytes
}

fn stream(dictionary: &str, content: &str) -> String {
    format!("<< {dictionary} /Length {} >>\nstream\n{content}\nendstream", content.len())
}

/// A PDF with a page of this size for each content; `extra` stands in every page, and `objects` follow, the first being
/// number 4 + 2 * pages.
fn pages(size: [f64; 2], contents: &[&str], extra: &str, objects: &[String]) -> Vec<u8> {
    let kids: String = (0..contents.len()).map(|i| format!("{} 0 R ", 4 + 2 * i)).collect();
    let mut all = vec![
        "<< /Type /Catalog /Pages 2 0 R >>".to_owned(),
        format!("<< /Type /Pages /Kids [{kids}] /Count {} >>", contents.len()),
        "<< /Type /Font /Subtype /Type1 /BaseFont /Helvetica >>".to_owned(),
    ];
    for (i, content) in contents.iter().enumerate() {
        let image = 4 + 2 * contents.len();
        all.push(format!(
            "<< /Type /Page /Parent 2 0 R /MediaBox [0 0 {} {}] /Contents {} 0 R {extra} /Resources << /Font << /F1 3 0 R >> \
             /XObject << /Im {image} 0 R >> >> >>",
            size[0],
            size[1],
            5 + 2 * i
        ));
        all.push(stream("", content));
    }
    all.extend_from_slice(objects);
    pdf_of(&all, "")
}

fn request(page: u32, dpi: f64) -> PageRequest {
    PageRequest { page, dpi, layers: None }
}

fn complaint(bytes: &[u8], number: u32) -> String {
    page(bytes, &request(number, 72.0)).unwrap_err().to_string()
}

const BLACK_BOX: &str = "0 g 10 10 20 30 re f";

#[test]
fn lines_are_drawn_at_the_density_asked_for() {
    let bytes = pages([144.0, 72.0], &[BLACK_BOX], "", &[]);
    let page = page(&bytes, &request(1, 144.0)).unwrap();
    assert_eq!((page.picture.dimensions(), page.dpi), ((288, 144), Some(144.0)));
    // 10 to 30 points from the left, 10 to 40 from below.
    for (x, y, value) in
        [(21, 122, 0), (58, 66, 0), (17, 100, 255), (63, 100, 255), (40, 61, 255), (40, 126, 255)]
    {
        assert_eq!(page.picture.get_pixel(x, y).0, [value; 3], "{x} {y}");
    }
    assert!(page.warnings.is_empty());
}

#[test]
fn words_have_their_place_and_angle() {
    let content = "BT /F1 20 Tf 100 50 Td (Room 12) Tj ET BT /F1 20 Tf 0 1 -1 0 50 100 Tm (Hall) Tj ET";
    let page = page(&pages([300.0, 200.0], &[content], "", &[]), &request(1, 144.0)).unwrap();
    let [room, hall] = &page.texts[..] else { panic!("{:?}", page.texts) };
    assert_eq!((room.content.as_str(), hall.content.as_str()), ("Room 12", "Hall"));
    // Helvetica: capitals reach from 0 to 0.72 em; the baselines are at 2 * (200 - 50) and at 2 * 50.
    assert!((room.centre[1] - 286.0).abs() < 2.0 && (hall.centre[0] - 86.0).abs() < 2.0, "{room:?} {hall:?}");
    assert!((room.centre[0] - room.width / 2.0 - 200.0).abs() < 1.0, "{room:?}");
    assert!((hall.centre[1] + hall.width / 2.0 - 200.0).abs() < 1.0, "{hall:?}");
    assert!(room.angle.abs() < 1e-9 && (hall.angle + FRAC_PI_2).abs() < 1e-9);
    assert!((160.0..165.0).contains(&room.width) && (27.0..31.0).contains(&room.height), "{room:?}");
}

#[test]
fn turned_pages_are_upright() {
    let content = "BT /F1 20 Tf 0 1 -1 0 50 100 Tm (Hall) Tj ET";
    let page = page(&pages([300.0, 200.0], &[content], "/Rotate 90", &[]), &request(1, 72.0)).unwrap();
    assert_eq!(page.picture.dimensions(), (200, 300));
    assert!(page.texts[0].angle.abs() < 1e-9, "{:?}", page.texts);
}

#[test]
fn a_scan_keeps_its_own_density() {
    let hex = "00ff".repeat(50 * 25);
    let image = stream(
        "/Type /XObject /Subtype /Image /Width 100 /Height 25 /ColorSpace /DeviceGray /BitsPerComponent 8 /Filter \
         /ASCIIHexDecode",
        &format!("{hex}>"),
    );
    let content = "q 40 0 0 10 0 0 cm /Im Do Q BT 3 Tr /F1 5 Tf 1 1 Td (recognised) Tj ET";
    let page = page(&pages([40.0, 10.0], &[content], "", &[image]), &request(1, 72.0)).unwrap();
    assert_eq!(page.picture.dimensions(), (100, 25));
    assert!((page.dpi.unwrap() - 180.0).abs() < 1e-6);
    assert_eq!((page.texts[0].content.as_str(), page.texts[0].confidence), ("recognised", 0.8));
}

#[test]
fn pages_that_are_not_there_are_told() {
    let bytes = pages([72.0, 72.0], &[BLACK_BOX; 3], "", &[]);
    assert_eq!(complaint(&bytes, 4), "there is no page 4: the document has 3 pages; give page=1 to page=3");
    assert!(page(&bytes, &request(3, 72.0)).is_ok());
}

#[test]
fn empty_broken_and_encrypted_have_their_sentences() {
    let blank = pages([72.0, 72.0], &[""], "", &[]);
    assert!(complaint(&blank, 1).starts_with("page 1 of the PDF is empty"));
    let none = pages([72.0, 72.0], &[], "", &[]);
    let message = complaint(&none, 1);
    assert!(message.contains("no pages") || message.contains("no readable pages"), "{message}");
    assert!(complaint(b"%PDF-1.4\njunk", 1).starts_with("the PDF is damaged"));
    let plain =
        ["<< /Type /Catalog /Pages 2 0 R >>", "<< /Type /Pages /Kids [] /Count 0 >>"].map(String::from);
    let key = "00".repeat(32);
    let lock =
        format!("/ID [<00><00>] /Encrypt << /Filter /Standard /V 1 /R 2 /P -4 /O <{key}> /U <{key}> >>");
    let message = complaint(&pdf_of(&plain, &lock), 1);
    assert_eq!(message, "the PDF is encrypted and opens with a password only; save it without a password");
}

#[test]
fn huge_pages_are_drawn_smaller() {
    let bytes = pages([14_400.0, 14_400.0], &[BLACK_BOX], "", &[]);
    let pdf = Pdf::new(bytes).unwrap();
    let page = &pdf.pages()[0];
    let scale = Scale::of(page, &Survey::of(page), 200.0);
    let pixels = u64::from(scale.width) * u64::from(scale.height);
    assert!(pixels <= MAX_PIXELS && pixels > MAX_PIXELS * 99 / 100, "{pixels}");
    let warning = scale.warning().unwrap();
    assert!(warning.starts_with("the page is drawn with 50 pixels per inch instead of 200"), "{warning}");
}

#[test]
fn pictures_that_claim_too_much_are_refused() {
    let image = stream(
        "/Type /XObject /Subtype /Image /Width 60000 /Height 60000 /ColorSpace /DeviceGray /BitsPerComponent 8",
        "x",
    );
    let message = complaint(&pages([72.0, 72.0], &["/Im Do"], "", &[image]), 1);
    assert!(
        message.starts_with("a picture on the PDF page has 60000 x 60000 pixels; at most 100"),
        "{message}"
    );
}

#[test]
fn cut_short_is_an_error_or_a_page() {
    let bytes = pages([72.0, 72.0], &[BLACK_BOX], "", &[]);
    for length in (0..bytes.len()).step_by(7) {
        let _ = page(&bytes[..length], &request(1, 72.0));
    }
    assert_eq!(page(&bytes[..60], &request(1, 72.0)).unwrap_err().kind, ErrorKind::BadInput);
}

proptest::proptest! {
    #![proptest_config(proptest::test_runner::Config::with_cases(64))]
    /// A panic in the reader would come out as the guard's sentence.
    #[test]
    fn damage_never_panics(at in proptest::collection::vec((0..2000_usize, 0..=255_u8), 1..6)) {
        let content = format!("{BLACK_BOX} BT /F1 20 Tf 10 50 Td (Room) Tj ET");
        let mut bytes = pages([72.0, 72.0], &[&content], "", &[]);
        let length = bytes.len();
        at.into_iter().for_each(|(i, b)| bytes[i % length] = b);
        let _ = page(&bytes, &request(1, 72.0));
    }
}
