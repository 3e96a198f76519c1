// SPDX-License-Identifier: MIT
// As vectors.py: rustc vectors.rs && ./vectors FILE
struct Vector {
    numbers: Vec<f64>,
    answer: String,
    t: Option<f64>,
    margin: Option<f64>, // of the other decision
    touch: bool,
}

fn after<'a>(line: &'a str, key: &str) -> Option<&'a str> {
    line.split_once(key).map(|(_, rest)| rest)
}

fn number(bits: &str) -> f64 {
    f64::from_bits(u64::from_str_radix(bits.trim_matches('"'), 16).unwrap())
}

fn read(line: &str) -> Vector {
    let case = after(line, "\"case_bits\":[").unwrap().split(']').next().unwrap();
    let answer = after(line, "\"answer\":\"").unwrap().split('"').next().unwrap();
    let other = if answer == "hit" { "\"miss\":" } else { "\"hit\":" };
    Vector {
        numbers: case.split(',').map(number).collect(),
        answer: answer.to_string(),
        t: after(line, "\"t_bits\":\"").map(|rest| number(&rest[..16])),
        margin: after(line, other).map(|rest| rest.split([',', '}']).next().unwrap().parse().unwrap()),
        touch: line.contains("\"event\":\"touch\""),
    }
}

fn main() {
    let path = std::env::args().nth(1).expect("FILE");
    let text = std::fs::read_to_string(&path).expect("a file");
    let (head, body) = text.split_once('\n').expect("a head");
    let mut digest: u64 = 0xcbf29ce484222325;
    for byte in body.bytes() {
        digest = (digest ^ byte as u64).wrapping_mul(0x100000001b3);
    }
    assert!(head.contains("\"surehit_vectors\":2,") && head.contains(&format!("{digest:016x}")));
    for vector in body.lines().map(read) {
        for number in &vector.numbers {
            print!("{number} ");
        }
        let t = vector.t.map_or(String::new(), |t| format!(" {t}"));
        let other = if vector.answer == "hit" { " or miss" } else { " or hit" };
        let may_be = vector.touch || vector.margin.is_some_and(|margin| margin <= 1e-9);
        println!(": {}{}{}", vector.answer, t, if may_be { other } else { "" });
    }
}
