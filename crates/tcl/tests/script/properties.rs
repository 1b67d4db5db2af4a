//! Properties that hold for any input.

use hysteron_tcl::Value;
use num_bigint::BigInt;
use num_integer::Integer as _;
use num_traits::Zero as _;
use proptest::prelude::*;

use super::{elements, interp};

/// The result of a command given as words, or the text of its error.
fn call(words: &[&str]) -> String {
    let (mut interp, ..) = interp();
    let list = Value::list(words.iter().map(|w| Value::from(*w)));
    match interp.eval_value(&list) {
        Ok(v) => v.as_str().into_owned(),
        Err(e) => panic!("{words:?}: {e:?}"),
    }
}

/// Text with many characters that mean something to Tcl.
fn tclish() -> impl Strategy<Value = String> {
    let letters = r#"[ \t\n;"\\{}\[\]$()a-c0-3+*/<>=!&|?:,.#~^%e-]{0,40}"#;
    prop_oneof![letters, "\\PC{0,30}"]
}

/// A value that a variable of an expression may have.
fn operand() -> impl Strategy<Value = String> {
    let odd = ["0x10", " 7 ", "abc", "", "yes", "9223372036854775807", "9007199254740993", "1e308", "-0.0", "1 2 3"];
    prop_oneof![
        (-9i64..10).prop_map(|i| i.to_string()),
        (-20i64..20).prop_map(|i| format!("{}", i as f64 * 0.25)),
        prop::num::f64::NORMAL.prop_map(|d| Value::from(d).as_str().into_owned()),
        any::<i64>().prop_map(|i| i.to_string()),
        prop::sample::select(odd.to_vec()).prop_map(str::to_owned),
    ]
}

/// An expression of the variables `a`, `b` and `l`.
fn expression() -> impl Strategy<Value = String> {
    let leaves =
        ["$a", "$b", "2", "0.5", "-3", "[llength $l]", "[lindex $l $a]", "[lindex $l 1]", "[string length $b]"];
    prop::sample::select(leaves.to_vec()).prop_map(str::to_owned).prop_recursive(4, 24, 3, |inner| {
        let operators =
            ["+", "-", "*", "/", "%", "**", "<", ">", "<=", ">=", "==", "!=", "&&", "||", "&", "|", "^", "eq", "<<"];
        let functions = ["abs", "int", "round", "double", "sqrt", "sin", "floor", "exp", "-", "!", "+", "~"];
        let two = ["max", "min", "pow", "hypot", "fmod", "atan2"];
        prop_oneof![
            4 => (inner.clone(), prop::sample::select(operators.to_vec()), inner.clone())
                .prop_map(|(x, op, y)| format!("({x} {op} {y})")),
            2 => (prop::sample::select(functions.to_vec()), inner.clone()).prop_map(|(f, x)| format!("{f}({x})")),
            1 => (prop::sample::select(two.to_vec()), inner.clone(), inner.clone())
                .prop_map(|(f, x, y)| format!("{f}({x}, {y})")),
            1 => (inner.clone(), inner.clone(), inner).prop_map(|(x, y, z)| format!("({x} ? {y} : {z})")),
        ]
    })
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(1000) })]

    /// The first evaluation of an expression takes the general way. Later ones take that of numbers, if there is one.
    #[test]
    fn an_expression_gives_the_same_each_time(text in expression(), a in operand(), b in operand(), l in operand()) {
        let (mut interp, ..) = interp();
        let words = [a, b, l].map(Value::from);
        let body = format!("for {{set i 0}} {{$i < 3}} {{incr i}} {{lappend r [list [catch {{expr {{{text}}}}} m] $m]}}; set r");
        interp.eval_str("p.tcl", &format!("proc f {{a b l}} {{{body}}}")).unwrap();
        let call = Value::list(std::iter::once(Value::from("f")).chain(words));
        let results = elements(&interp.eval_value(&call).unwrap());
        prop_assert_eq!(&results[0], &results[1]);
        prop_assert_eq!(&results[0], &results[2]);
    }
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(300) })]

    #[test]
    fn a_list_keeps_its_elements(items in prop::collection::vec(tclish(), 0..8)) {
        let list = Value::list(items.iter().map(|i| Value::from(i.as_str())));
        let text = list.as_str().into_owned();
        prop_assert_eq!(elements(&Value::from(text.as_str())), items.clone());
        // As words of a script too, and as an element of another list.
        let (mut interp, ..) = interp();
        let again = interp.eval_str("p.tcl", &format!("list {text}")).unwrap();
        prop_assert_eq!(elements(&again), items);
        let outer = Value::list([list]);
        prop_assert_eq!(&elements(&Value::from(&*outer.as_str()))[0], &text);
    }

    #[test]
    fn any_text_is_a_script_or_an_error(text in tclish()) {
        let (mut interp, ..) = interp();
        interp.budget = Some(2000);
        let _ = interp.eval_str("p.tcl", &text);
        let _ = interp.eval_value(&Value::from(text.as_str()));
    }

    #[test]
    fn any_text_is_an_expression_or_an_error(text in tclish()) {
        let (mut interp, ..) = interp();
        interp.budget = Some(2000);
        let _ = interp.eval_value(&Value::list([Value::from("expr"), Value::from(text.as_str())]));
        let _ = interp.eval_str("p.tcl", &format!("expr {{{text}}}"));
    }

    #[test]
    fn any_text_is_a_pattern_or_an_error(pattern in tclish(), text in tclish()) {
        let (mut interp, ..) = interp();
        for words in [
            vec!["regexp", "-all", "-inline", "--", &pattern, &text],
            vec!["regsub", "-all", "--", &pattern, &text, "<&>"],
            vec!["string", "match", &pattern, &text],
            vec!["format", &pattern, &text, "1", "2"],
            vec!["scan", &text, &pattern],
            vec!["binary", "scan", &text, &pattern],
            vec!["clock", "format", "0", "-gmt", "1", "-format", &pattern],
            vec!["clock", "scan", &text, "-gmt", "1", "-format", &pattern],
            vec!["clock", "scan", &text, "-gmt", "1"],
            vec!["subst", &text],
            vec!["glob", "-nocomplain", "--", &pattern],
            vec!["lindex", &text, &pattern],
            vec!["dict", "get", &text, &pattern],
            vec!["string", "is", "list", &text],
            vec!["string", "is", "double", "-failindex", "i", &text],
            vec!["file", "join", &pattern, &text],
            vec!["file", "normalize", &text],
            vec!["info", "complete", &text],
        ] {
            interp.budget = Some(2000);
            let _ = interp.eval_value(&Value::list(words.into_iter().map(Value::from)));
        }
    }

    #[test]
    fn integers_are_written_as_in_rust(i: i64, width in 0usize..30) {
        let number = i.to_string();
        prop_assert_eq!(call(&["format", "%d", &number]), i.to_string());
        prop_assert_eq!(call(&["format", &format!("%{width}d"), &number]), format!("{i:width$}"));
        prop_assert_eq!(call(&["format", "%x", &number]), format!("{i:x}"));
        prop_assert_eq!(call(&["scan", &number, "%d"]), number);
    }

    #[test]
    fn doubles_are_written_as_in_rust(d in prop::num::f64::NORMAL, precision in 0usize..20) {
        let number = Value::from(d);
        prop_assert_eq!(number.as_str().parse::<f64>().unwrap(), d);
        prop_assert_eq!(Value::from(&*number.as_str()).to_f64().unwrap(), d);
        prop_assert_eq!(call(&["format", &format!("%.{precision}f"), &number.as_str()]), format!("{d:.precision$}"));
        let (size, sign) = (d.abs(), format!("{d:e}").replace('e', "e+").replace("e+-", "e-"));
        prop_assert!((1e-4..1e17).contains(&size) || *number.as_str() == *sign);
        let general = call(&["format", "%.17g", &number.as_str()]);
        prop_assert_eq!(general.parse::<f64>().unwrap(), d);
    }

    #[test]
    fn arithmetic_is_exact(
        a in "-?[1-9][0-9]{0,40}",
        b in "-?[1-9][0-9]{0,25}",
        shift in 0u32..90,
    ) {
        let (x, y): (BigInt, BigInt) = (a.parse().unwrap(), b.parse().unwrap());
        let expr = |text: String| call(&["expr", &text]);
        prop_assert_eq!(expr(format!("{a} + {b}")), (&x + &y).to_string());
        prop_assert_eq!(expr(format!("{a} - {b}")), (&x - &y).to_string());
        prop_assert_eq!(expr(format!("{a} * {b}")), (&x * &y).to_string());
        prop_assert_eq!(expr(format!("{a} / {b}")), x.div_floor(&y).to_string());
        prop_assert_eq!(expr(format!("{a} % {b}")), x.mod_floor(&y).to_string());
        prop_assert_eq!(expr(format!("{a} & {b}")), (&x & &y).to_string());
        prop_assert_eq!(expr(format!("{a} | {b}")), (&x | &y).to_string());
        prop_assert_eq!(expr(format!("{a} ^ {b}")), (&x ^ &y).to_string());
        prop_assert_eq!(expr(format!("{a} << {shift}")), (&x << shift).to_string());
        prop_assert_eq!(expr(format!("{a} >> {shift}")), (&x >> shift).to_string());
        prop_assert_eq!(expr(format!("{a} < {b}")), i32::from(x < y).to_string());
        prop_assert_eq!(expr(format!("({a}) ** 3")), x.pow(3).to_string());
        prop_assert!(!x.is_zero());
    }

    #[test]
    fn small_integers_divide_towards_minus_infinity(a in -1000i64..1000, b in -50i64..50) {
        prop_assume!(b != 0);
        prop_assert_eq!(call(&["expr", &format!("{a} / {b}")]), num_integer::div_floor(a, b).to_string());
        prop_assert_eq!(call(&["expr", &format!("{a} % {b}")]), num_integer::mod_floor(a, b).to_string());
    }

    #[test]
    fn sorting_sorts(mut numbers in prop::collection::vec(-100i64..100, 0..30)) {
        let list = Value::list(numbers.iter().map(|n| Value::from(*n)));
        let sorted = call(&["lsort", "-integer", &list.as_str()]);
        numbers.sort_unstable();
        let sorted: Vec<i64> = elements(&Value::from(sorted)).iter().map(|n| n.parse().unwrap()).collect();
        prop_assert_eq!(sorted, numbers);
    }

    #[test]
    fn joining_undoes_splitting(text in "[a-c,;]{0,20}") {
        let list = call(&["split", &text, ",;"]);
        let joined = call(&["join", &list, ","]);
        prop_assert_eq!(joined, text.replace(';', ","));
    }

    #[test]
    fn a_dictionary_keeps_its_last_values(pairs in prop::collection::vec(("[a-e]", "[a-z ]{0,5}"), 0..12)) {
        let (mut interp, ..) = interp();
        let words = pairs.iter().flat_map(|(k, v)| [Value::from(k.as_str()), Value::from(v.as_str())]);
        interp.set_var("pairs", Value::list(words)).unwrap();
        interp.eval_str("p.tcl", "set d {}; foreach {k v} $pairs {dict set d $k $v}").unwrap();
        let dict = elements(&interp.get_var("d").unwrap());
        let mut expected: Vec<(String, String)> = vec![];
        for (k, v) in pairs {
            match expected.iter_mut().find(|(old, _)| *old == k) {
                Some(entry) => entry.1 = v,
                None => expected.push((k, v)),
            }
        }
        prop_assert_eq!(dict, expected.into_iter().flat_map(|(k, v)| [k, v]).collect::<Vec<_>>());
    }
}
