//! Bad polyhedron files: what is said and where.

use partplan::cone::format::{FormatFault, MAX_COLUMNS, read};

/// `§` stands before the place that the fault must point at.
const FAULTS: &[(&str, &str)] = &[
    ("§", "no line \"begin\"; write begin, a line such as \"4 3 rational\", the rows and end"),
    ("H-representation\n3 2 integer\n1 1\n§", "no line \"begin\""),
    ("begin\n§", "the file ends where the number of rows should follow"),
    ("begin\n3§", "the file ends where the number of columns should follow"),
    ("begin\n3 2 §", "the file ends where integer, rational or real should follow"),
    ("begin\n§three 2 integer\n", "\"three\" is no number of rows; write the number of rows, that of columns"),
    ("begin\n§-3 2 integer\n", "\"-3\" is no number of rows"),
    ("begin\n3 §2.0 integer\n", "\"2.0\" is no number of columns"),
    ("begin\n3 §0 integer\nend", "0 columns; a row has at least the constant"),
    ("begin\n0 §1000000000 integer\nend", "1000000000 columns, more than the 1000 that are accepted"),
    ("begin\n0 §99999999999999999999999 integer\nend", "more than the 1000 that are accepted"),
    ("begin\n2 2 §float\n1 1\n1 1\nend", "\"float\" is no kind of number; write integer, rational or real"),
    ("begin\n2 2 integer\n1 1\n1 §x\nend", "\"x\" is no number (row 2, entry 2); write 3, -1/3 or 0.25"),
    ("begin\n2 2 integer\n1 1\n1 §--1\nend", "\"--1\" is no number"),
    ("begin\n2 2 real\n1 1\n1 §.\nend", "\".\" is no number"),
    ("begin\n2 2 real\n1 1\n1 §nan\nend", "\"nan\" is no number"),
    ("begin\n2 2 rational\n1 §1/0\n1 1\nend", "the denominator of \"1/0\" is zero (row 1, entry 2)"),
    ("begin\n1 2 real\n1 §1e999999999\nend", "the exponent of \"1e999999999\" is beyond ±400 (row 1, entry 2)"),
    ("begin\n1 2 real\n§-1.5E-0401 1\nend", "is beyond ±400 (row 1, entry 1)"),
    ("begin\n3 3 integer\n1 1 1\n1 1\n1 1 1\n§end", "row 3 has 2 of 3 entries; 3 rows of 3 entries are announced"),
    ("begin\n***** 3 integer\n1 1 1\n1 1\n§end", "row 2 has 2 of 3 entries; ***** rows"),
    ("begin\n3 2 integer\n1 1\n1 1\n  §end", "2 rows where 3 are announced; correct the number after \"begin\""),
    ("begin\n18446744073709551615 2 integer\n1 1\n§end", "1 rows where 18446744073709551615 are announced"),
    ("begin\n1 2 integer\n1 1\n§1 1\nend", "\"1\" where \"end\" should follow the 1 announced rows of 2 entries"),
    ("begin\n1 2 integer\n1 1 §7\nend", "\"7\" where \"end\" should follow"),
    ("begin\n1 2 integer\n1 1\n§", "the file ends where a row or \"end\" should follow"),
    ("begin\n1 2 integer\n1§", "the file ends where the rest of a row should follow"),
    (
        "V-representation\nbegin\n2 2 integer\n1 1\n§2 1\nend",
        "row 2 of a V-representation starts with \"2\"; write 1 for",
    ),
    ("V-representation\nbegin\n1 2 integer\n§-1 1\nend", "starts with \"-1\"; write 1 for a point and 0 for a ray"),
    ("linearity 2 1 §x\nbegin", "\"x\" where a row number should follow; write linearity, how many rows and which"),
    ("linearity 3 1 2\n§begin\n1 2 integer\n1 1\nend", "\"begin\" where a row number should follow"),
    ("linearity 1 1 §2\nbegin", "\"2\" where the end of the line should follow"),
    ("linearity §one 1\nbegin", "\"one\" where the number of rows in the list should follow"),
    ("equality 1 §-1\nbegin", "\"-1\" where a row number should follow; write equality,"),
    ("linearity§", "the file ends where the number of rows in the list should follow"),
    ("linearity 99999999999 1§", "the file ends where a row number should follow"),
    ("linearity 1 §3\nbegin\n2 2 integer\n1 1\n1 2\nend", "row 3 is out of range; the rows have the numbers 1 to 2"),
    ("linearity 1 §0\nbegin\n2 2 integer\n1 1\n1 2\nend", "row 0 is out of range"),
    ("begin\n0 2 integer\nend\nlinearity 1 §1", "row 1 is out of range; there are no rows"),
    ("V-representation\nlinearity 1 §1\nbegin\n1 2 integer\n1 1\nend", "row 1 is a point; only rays"),
    ("H-representation\n  §V-representation\nbegin", "both an H- and a V-representation; a file holds one"),
    ("V-representation\nbegin\n0 2 integer\nend\n§H-representation", "both an H- and a V-representation"),
    ("begin\n0 2 integer\nend\n§begin\n", "a second \"begin\"; a file holds one polyhedron"),
    ("begin\n1 2 integer\n1 1\nend\n§strict_inequality 1 1", "\"strict_inequality\" changes the polyhedron"),
    ("§nonnegative\nbegin", "\"nonnegative\" changes the polyhedron and is not understood; write the rows x_i >= 0"),
];

#[test]
fn every_fault_is_told_with_its_place() {
    for (marked, message) in FAULTS {
        let (before, after) = marked.split_once('§').unwrap();
        let line = before.split('\n').count();
        let column = before.rsplit('\n').next().unwrap().chars().count() + 1;
        let fault = read(format!("{before}{after}").as_bytes()).expect_err(marked);
        assert_eq!((fault.line, fault.column), (line, column), "{marked}\n{fault}");
        assert!(fault.fault.to_string().contains(message), "{marked}\n{fault}");
        assert_eq!(fault.to_string(), format!("{line}:{column}: {}", fault.fault));
    }
}

#[test]
fn columns_count_characters_of_text_that_may_be_no_text() {
    let fault = read("Körper ä\nbegin\n1 2 integer\nü".as_bytes()).unwrap_err();
    assert_eq!((fault.line, fault.column), (4, 1));
    let fault = read("begin\n1 2 integer\n1  ü\nend".as_bytes()).unwrap_err();
    assert_eq!((fault.line, fault.column), (3, 4));
    assert!(read(b"K\xf6rper\nbegin\n1 2 integer\n1 1\nend").is_ok());
    assert!(read(b"begin\n1 2 integer\n1 \xff\nend").is_err());
}

#[test]
fn as_many_columns_as_are_accepted_can_be_converted() {
    let text =
        |columns: usize| format!("V-representation\nbegin\n1 {columns} integer\n1{}\nend", " 0".repeat(columns - 1));
    assert!(read(text(MAX_COLUMNS).as_bytes()).is_ok());
    let fault = read(text(MAX_COLUMNS + 1).as_bytes()).unwrap_err().fault;
    assert_eq!(fault, FormatFault::TooManyColumns { columns: (MAX_COLUMNS + 1).to_string() });
}

#[test]
fn long_words_are_shown_short() {
    let fault = read(format!("begin\n1 2 integer\n1 {}\nend", "x".repeat(10_000)).as_bytes()).unwrap_err();
    assert!(fault.to_string().len() < 200, "{fault}");
}
