//! Laws in closed form: what is read and refused, and that file, interpreter and printed crate mean
//! the same. Values are compared with a walk over the expression in plain `f64`.

use std::path::Path;
use std::process::Command;

use dh_codegen::arm::param;
use dh_codegen::arm::{Function, Model};
use dh_codegen::interpret::{Interpreter, State};
use dh_codegen::robot::{JointKind, LawFunction, Robot, Run, Term, TorqueLaw, Variable, no_files};

const TWO: [JointKind; 2] = [JointKind::Revolute, JointKind::Prismatic];

fn file(joints: &str) -> String {
    format!(
        "name: lawful\nconvention: modified\nconstants: {{ A: 0.7, L1: 0.4, phase: 30deg }}\njoints:\n{joints}links:\n  - {{ M: 2, MS: [0.1, 0, 0.2], I: [0.1, 0.1, 0.1, 0, 0, 0] }}\n  - {{ M: 1, MS: [0, 0.05, 0], I: [0.05, 0.05, 0.05, 0, 0, 0] }}\n"
    )
}

/// A turning and a sliding joint with these further keys.
fn two(first: &str, second: &str) -> String {
    file(&format!(
        "  - {{ type: revolute, alpha: pi/2{first} }} # the turning one\n  - {{ type: prismatic, alpha: pi/2, d: L1{second} }}\n"
    ))
}

fn robot(text: &str) -> Robot {
    Robot::from_yaml(text, &no_files).unwrap_or_else(|e| panic!("{e}\n{text}")).robot
}

fn law(robot: &Robot, row: usize) -> &TorqueLaw {
    robot.joints[row].drive.law.as_ref().unwrap()
}

/// State and clock for the walk.
struct At {
    q: Vec<f64>,
    dq: Vec<f64>,
    ddq: Vec<f64>,
    temp: Vec<f64>,
    t: f64,
}

fn value(term: &Term, at: &At) -> f64 {
    let of = |x: &Term| value(x, at);
    match term {
        Term::Number(x) => *x,
        Term::Variable(Variable::Position(k)) => at.q[*k],
        Term::Variable(Variable::Velocity(k)) => at.dq[*k],
        Term::Variable(Variable::Acceleration(k)) => at.ddq[*k],
        Term::Variable(Variable::Temperature(k)) => at.temp[*k],
        Term::Variable(Variable::Time) => at.t,
        Term::Negative(x) => -of(x),
        Term::Inverse(x) => 1.0 / of(x),
        Term::Sum(all) => all.iter().map(of).sum(),
        Term::Product(all) => all.iter().map(of).product(),
        Term::Power(x, n) => of(x).powf(*n),
        Term::Least(x, y) => of(x).min(of(y)),
        Term::Most(x, y) => of(x).max(of(y)),
        Term::Call(function, x) => {
            let x = of(x);
            match function {
                LawFunction::Sin => x.sin(),
                LawFunction::Cos => x.cos(),
                LawFunction::Exp => x.exp(),
                LawFunction::Ln => x.ln(),
                LawFunction::Sqrt => x.sqrt(),
                LawFunction::Abs => x.abs(),
                LawFunction::Sign if x == 0.0 => 0.0,
                LawFunction::Sign => x.signum(),
                LawFunction::Tanh => x.tanh(),
            }
        }
    }
}

/// Numbers for tests (xorshift64*).
struct Random(u64);

impl Random {
    fn below(&mut self, n: usize) -> usize {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        (self.0.wrapping_mul(0x2545_F491_4F6C_DD1D) >> 33) as usize % n
    }

    fn within(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.below(1_000_000_007) as f64 / 1_000_000_007.0
    }

    /// An expression without a unit that has a value everywhere.
    fn term(&mut self, joints: usize, depth: usize) -> Term {
        let number = Term::Number(self.within(-2.0, 2.0));
        let pair = |a: Term, b: Term| (Box::new(a), Box::new(b));
        if depth == 0 {
            let k = self.below(joints);
            let variable = match self.below(6) {
                0 | 1 => Variable::Position(k),
                2 => Variable::Velocity(k),
                3 => Variable::Acceleration(k),
                4 => Variable::Temperature(k),
                _ => Variable::Time,
            };
            // A number that carries the unit, so that anything can be added to anything.
            return Term::Product(vec![Term::Number(self.within(0.1, 0.9)), Term::Variable(variable)]);
        }
        let of = |random: &mut Self| random.term(joints, depth - 1);
        match self.below(12) {
            0 => Term::Sum(vec![of(self), number, of(self)]),
            1 => Term::Sum(vec![of(self), Term::Negative(Box::new(of(self)))]),
            2 => Term::Product(vec![number, of(self), of(self)]),
            3 => {
                let square = Term::Power(Box::new(of(self)), 2.0);
                let divisor = Term::Inverse(Box::new(Term::Sum(vec![square, Term::Number(0.5)])));
                Term::Product(vec![of(self), divisor])
            }
            4 => Term::Negative(Box::new(of(self))),
            5 => {
                let size = Term::Call(LawFunction::Abs, Box::new(of(self)));
                let n = [0.5, 1.5, 0.3, 2.0, 3.0, -1.0, -0.7][self.below(7)];
                Term::Power(Box::new(Term::Sum(vec![size, Term::Number(0.1)])), n)
            }
            6 => {
                let (a, b) = pair(of(self), of(self));
                Term::Least(a, b)
            }
            7 => {
                let (a, b) = pair(of(self), of(self));
                Term::Most(a, b)
            }
            8 => {
                let size = Term::Call(LawFunction::Abs, Box::new(of(self)));
                let root = Term::Call(LawFunction::Sqrt, Box::new(size));
                let ln = Term::Call(LawFunction::Ln, Box::new(Term::Sum(vec![Term::Number(1.0), root])));
                Term::Product(vec![ln, of(self)])
            }
            9 => {
                let flat = Term::Call(LawFunction::Tanh, Box::new(of(self)));
                Term::Call(LawFunction::Exp, Box::new(flat))
            }
            _ => {
                let function =
                    [LawFunction::Sin, LawFunction::Cos, LawFunction::Tanh, LawFunction::Sign][self.below(4)];
                Term::Call(function, Box::new(of(self)))
            }
        }
    }
}

#[test]
fn what_is_read() {
    for (text, shown) in [
        ("0.7*sin(3*q1)*sign(dq1)", "0.7*sin(3*q1)*sign(dq1)"),
        (" 2 ", "2"),
        ("-q1^2*3", "-q1^2*3"),
        ("(q1)*(-3)", "q1*(-3)"),
        ("1 - (2 - q1)", "1 - (2 - q1)"),
        ("1/(2*(abs(dq1) + 0.5))", "1/(2*(abs(dq1) + 0.5))"),
        ("2*abs(dq1)^0.5*sign(dq1)", "2*abs(dq1)^0.5*sign(dq1)"),
        ("2*(q1^2 + 0.1)^-2", "2*(q1^2 + 0.1)^-2"),
        ("min(2*q1, 1) + max(dq1, -0.5)*3", "min(2*q1, 1) + max(dq1, -0.5)*3"),
        ("0.2*exp(-t/30)*sqrt(t)", "0.2*exp(-t/30)*sqrt(t)"),
        ("0.1*(temp2 - 25)", "0.1*(temp2 - 25)"),
        ("3*tanh(dq2/0.01)", "3*tanh(dq2/0.01)"),
        ("1.5e-3*q2*ddq1", "0.0015*q2*ddq1"),
        ("+q1", "q1"),
        ("cos(2*pi*q1)", "cos(2*3.141592653589793*q1)"),
    ] {
        let law = TorqueLaw::parse(text, &TWO).unwrap_or_else(|e| panic!("{e}"));
        assert_eq!(law.to_string(), shown, "{text}");
        assert_eq!(TorqueLaw::new(law.term(), &TWO).unwrap(), law, "{text}");
    }
}

/// Each with the character at which it is seen, from 1, and a part of what is said.
#[test]
fn what_is_refused_says_where_and_how_to_mend_it() {
    for (text, character, said) in [
        ("", 1, "the text is empty"),
        ("q", 1, "`q` has no meaning in a law; write the number of a joint behind it: q1"),
        ("2*q3", 3, "there is no joint of `q3`; the joints that move have q1 to q2"),
        ("q0", 1, "there is no joint of `q0`"),
        ("q01", 1, "there is no joint of `q01`"),
        ("dq99999999999999999999999", 1, "there is no joint of"),
        ("3*sine(q1)", 3, "did you mean `sin`?"),
        ("tan(q1)", 1, "it has poles"),
        ("2*tau1", 3, "a law is of positions q"),
        ("B*q1", 1, "`B` has no meaning in a law"),
        ("q1/0", 3, "division by zero"),
        ("1/(2 - 2)", 2, "division by zero"),
        ("1/q1", 2, "division by what may be 0"),
        ("q1^-1", 3, "division by what may be 0"),
        ("1/sin(q1)", 2, "division by what may be 0"),
        ("1/exp(q1)", 2, "division by what may be 0"),
        ("sqrt(q1)", 1, "sqrt of what may be negative; write sqrt(abs(x))"),
        ("sqrt(-2)", 1, "sqrt of what may be negative"),
        ("ln(abs(q1))", 1, "ln of what may be 0"),
        ("dq1^0.5", 4, "the power 0.5 of what may be negative"),
        ("q1^q1", 4, "the exponent has a variable in it"),
        ("q1^17", 4, "the power 17"),
        ("q1^2^3", 5, "a power of a power"),
        ("sin(q1, q1)", 4, "sin of 2, and it is of 1 number"),
        ("min(q1)", 4, "min of 1, and it is of 2 numbers"),
        ("sin()", 5, "a `)` without its `(`"),
        ("sin q1", 5, "`q1` follows without an operator"),
        ("2 q1", 3, "`q1` follows without an operator"),
        ("q1(2)", 3, "`(` follows without an operator"),
        ("q1**2", 3, "`**` is not read; write a power with `^`"),
        ("(q1", 1, "this bracket is not closed"),
        ("q1)", 3, "a `)` without its `(`"),
        ("q1 +", 5, "the expression ends too early"),
        ("q1; q1", 3, "`;` does not belong in a law"),
        ("1e999", 1, "too large for a number"),
        ("exp(1000)*q1", 1, "too large for a number"),
        ("1e200*1e200", 1, "too large for a number"),
        ("3 Nm", 3, "`Nm` follows a number"),
        // Units.
        ("sin(dq1)", 5, "sin of rad/s; it is of a plain number or an angle"),
        ("exp(q2)", 5, "exp of m; it is"),
        ("exp(t)", 5, "exp of s; it is"),
        ("tanh(temp1*q1)", 6, "tanh of K"),
        ("cos(q1*dq1)", 5, "cos of rad/s"),
        ("q1 + dq1", 4, "rad and rad/s are added"),
        ("2*(q1 - q2)", 7, "rad and m are added"),
        ("max(dq1, ddq1)", 10, "rad/s and rad/s^2 are compared"),
        ("sin(sqrt(t))", 5, "sin of s^0.5"),
        ("ln(1 + t)", 4, "ln of s"),
    ] {
        let error = TorqueLaw::parse(text, &TWO).expect_err(text);
        let (shown, place) = (error.to_string(), format!("character {character}:"));
        assert!(shown.contains(said) && shown.contains(&place) && !error.mend.is_empty(), "{text}: {shown}");
    }
}

#[test]
fn places_in_the_file_and_mistakes_there() {
    let beside = robot(&two(", law: \"A*sin(3*q1 + phase)\", unit: N m", ", unit: N, law: 5*dq2"));
    assert_eq!(law(&beside, 0).to_string(), "0.7*sin(3*q1 + 0.5235987755982988)");
    assert_eq!(law(&beside, 1).text(), "5*dq2");
    let within = robot(&two(", drive: { rotor_inertia: 0.1, law: \"A*sin(3*q1 + phase)\", unit: N m }", ""));
    assert_eq!(law(&within, 0), law(&beside, 0));
    assert_eq!(within.joints[0].drive.rotor_inertia, Some(0.1));
    // Under `effects` it is of every joint with that unit.
    let whole = robot(&(two("", "") + "effects: { law: \"2*dq1*q1\", unit: N }\n"));
    assert_eq!(whole.joints[0].drive.law, None);
    assert_eq!(law(&whole, 1).text(), "2*dq1*q1");
    assert!(whole.has_effects() && whole.effects.is_empty());

    for (first, second, more, place, said) in [
        (", law: 2*q1", "", "", "5:36: joints[1].law", "the key `unit` is missing; help: add `unit: N m`"),
        (", unit: N m", "", "", "5:36: joints[1].unit", "stands here without a `law`"),
        (", law: 2*q1, unit: N", "", "", "joints[1].unit", "`N` is not the unit of this torque; help: write N m"),
        (", law: 2*q1, unit: Nm", "", "", "joints[1].unit", "`Nm` is not"),
        ("", ", law: 2*q1, unit: N m", "", "joints[2].unit", "help: write N"),
        (", law: \"2*sin(q9)\", unit: N m", "", "", "5:48: joints[1].law", "there is no joint of `q9`"),
        (", law: 2*sin(q9), unit: N m", "", "", "5:47: joints[1].law", "there is no joint of `q9`"),
        (", law: [q1], unit: N m", "", "", "joints[1].law", "a list of 1 stands here"),
        (", law: { a: 1 }, unit: N m", "", "", "joints[1].law", "stands here; help: write an expression"),
        (", law: , unit: N m", "", "", "joints[1].law", "nothing stands here"),
        (", law: q1, unit: N m, drive: { law: q1, unit: N m }", "", "", "joints[1].drive.law", "law beside its drive"),
        (
            ", law: q1, unit: N m",
            "",
            "effects: { law: q1, unit: N m }\n",
            "effects.law",
            "joint 1 has a law of its own",
        ),
        ("", "", "effects: { law: q1 }\n", "effects.law", "add `unit: N m or N`"),
        ("", "", "effects: { lax: q1 }\n", "effects.lax", "did you mean `law`?"),
    ] {
        let text = two(first, second) + more;
        let problems = match Robot::from_yaml(&text, &no_files) {
            Ok(reading) => panic!("was read: {:?}\n{text}", reading.robot.all_effects()),
            Err(problems) => problems,
        };
        let shown = problems.to_string();
        assert!(shown.contains(place) && shown.contains(said), "{shown}\nfor {place}: {said}\n{text}");
        assert_eq!(problems.list().len(), 1, "{shown}");
    }
    let fixed = file("  - { type: fixed, law: 2, unit: N m }\n  - { type: revolute }\n");
    let said = Robot::from_yaml(&fixed, &no_files).unwrap_err().to_string();
    assert!(said.contains("a fixed joint has no torque"), "{said}");
    // A constant that is called like a variable is one until a law says it.
    let named = two("", "").replace("A: 0.7", "t: 0.7");
    assert!(Robot::from_yaml(&named, &no_files).is_ok());
    let said = Robot::from_yaml(&named.replace("alpha: pi/2 }", "law: 2*t, unit: N m }"), &no_files).unwrap_err();
    assert!(said.to_string().contains("`t` is a constant of this file and a variable of laws"), "{said}");
}

#[test]
fn a_file_is_written_back() {
    let text = two(", law: \"A*sin(3*q1  + phase)\", unit: N m", ", law: \"q2*3\", unit: N");
    let read = robot(&text);
    let written = read.to_yaml();
    assert!(written.contains("law: \"A*sin(3*q1 + phase)\", unit: N m"), "{written}");
    assert_eq!(robot(&written), read);
    // Constants that are gone are numbers.
    let mut bare = read.clone();
    bare.constants.clear();
    bare.joints[1].d = dh_codegen::robot::Length::meters(0.4);
    assert_eq!(law(&robot(&bare.to_yaml()), 0), law(&read, 0));
    // A law that was found goes where the old one stood, or beside the drive.
    let found = Term::Product(vec![Term::Number(0.25), Term::Variable(Variable::Velocity(0))]);
    let found = TorqueLaw::new(&found, &TWO).unwrap();
    for (text, words) in [
        (text.clone(), "alpha: pi/2, law: \"0.25*dq1\", unit: N m } # the turning one"),
        (two("", ""), "alpha: pi/2, law: \"0.25*dq1\", unit: \"N m\" } # the turning one"),
    ] {
        let mut changed = robot(&text);
        changed.joints[0].drive.law = Some(found.clone());
        let rewritten = changed.rewritten(&text, &no_files, &no_files, &Run::default());
        assert!(rewritten.replace("\"N m\"", "N m").contains(&words.replace("\"N m\"", "N m")), "{rewritten}");
        assert_eq!(robot(&rewritten), changed);
        changed.joints[0].drive.law = None;
        let without = changed.rewritten(&rewritten, &no_files, &no_files, &Run::default());
        assert_eq!(robot(&without), changed, "{without}");
        assert!(without.contains("# the turning one"), "{without}");
    }
    let inside = two(", drive: { law: 2*q1, unit: N m }", "");
    let mut changed = robot(&inside);
    assert_eq!(changed.rewritten(&inside, &no_files, &no_files, &Run::default()), inside);
    changed.joints[0].drive.law = Some(found);
    assert_eq!(robot(&changed.rewritten(&inside, &no_files, &no_files, &Run::default())), changed);
}

#[test]
fn any_expression_is_printed_and_read_again() {
    let mut random = Random(7);
    let at = At { q: vec![0.3, -0.8], dq: vec![1.2, -0.4], ddq: vec![2.0, -3.0], temp: vec![31.0, 24.0], t: 4.5 };
    for _ in 0..2000 {
        let depth = 1 + random.below(3);
        let term = random.term(2, depth);
        let law = TorqueLaw::new(&term, &TWO).unwrap_or_else(|e| panic!("{term}: {e}"));
        assert_eq!(TorqueLaw::parse(law.text(), &TWO).unwrap(), law);
        let (a, b) = (value(&term, &at), value(law.term(), &at));
        assert!(a.is_finite() && (a - b).abs() <= 1e-12 * (1.0 + a.abs()), "{term}: {a} {b}");
        let written = robot(&two(&format!(", unit: N m, law: \"{law}\""), ""));
        assert_eq!(robot(&written.to_yaml()), written);
    }
}

/// Whatever stands there: a law that is written and read again, or a mistake with its place.
#[test]
fn hostile_texts() {
    let words = [
        "q1", "dq2", "ddq1", "t", "temp1", "q9", "sin", "cos", "exp", "ln", "sqrt", "abs", "sign", "tanh", "min",
        "max", "(", ")", ",", "+", "-", "*", "/", "^", "pi", "deg", "rad", "0", "1", "2.5", "1e308", "1e-308", "-1",
        "0.5", " ", "A", "nan", "inf", "é", "\u{2212}", "'", "#", "1.2.3", "self", "fn", "q1(", "((", "^-", "^0.5",
    ];
    let mut random = Random(11);
    let mut read = 0;
    for _ in 0..40_000 {
        let len = 1 + random.below(14);
        let text: String = (0..len).map(|_| words[random.below(words.len())]).collect();
        match TorqueLaw::parse(&text, &TWO) {
            Ok(law) => {
                read += 1;
                assert_eq!(TorqueLaw::new(law.term(), &TWO).unwrap().to_string(), law.to_string(), "{text}");
            }
            Err(error) => assert!(!error.what.is_empty() && !error.mend.is_empty(), "{text}: {error}"),
        }
    }
    assert!(read > 500, "{read}");
    let deep = |open: &str, close: &str, n: usize| open.repeat(n) + "q1" + &close.repeat(n);
    for text in [
        deep("(", ")", 2000),
        deep("sin(", ")", 900),
        deep("-", "", 3900),
        deep("1+", "", 1900),
        deep("2*", "", 1900),
        deep("1/(1+abs(", "))", 400),
        deep("max(1,", ")", 600),
        "^".repeat(3000),
        "q1^".repeat(1300),
        "(".repeat(4000),
        "1".repeat(4001),
        "é".repeat(100_000),
    ] {
        let _read = TorqueLaw::parse(&text, &TWO);
    }
    assert!(TorqueLaw::parse(&deep("-", "", 3900), &TWO).is_ok());
    assert!(TorqueLaw::parse(&deep("1+", "", 1900), &TWO).is_ok());
    let long = TorqueLaw::parse(&"1".repeat(4001), &TWO).unwrap_err();
    assert!(long.what.contains("at most 4000 are read"), "{long}");
}

/// Six joints, one of them sliding, each with a law of many terms.
fn six(seed: u64) -> String {
    let mut random = Random(seed);
    let kinds: Vec<JointKind> =
        (0..6).map(|k| if k == 2 { JointKind::Prismatic } else { JointKind::Revolute }).collect();
    let mut joints = String::new();
    let mut links = String::new();
    for (k, kind) in kinds.iter().enumerate() {
        let terms: Vec<Term> = (0..4).map(|_| random.term(6, 2)).collect();
        let law = TorqueLaw::new(&Term::Sum(terms), &kinds).unwrap_or_else(|e| panic!("{e}"));
        let (word, unit) = if *kind == JointKind::Prismatic { ("prismatic", "N") } else { ("revolute", "N m") };
        joints += &format!(
            "  - {{ type: {word}, alpha: {}, d: 0.1, r: 0.2, law: \"{law}\", unit: {unit}, drive: {{ friction: {{ viscous_friction: 0.5, coulomb_friction: 0.3 }}, encoder_offset: 0.01 }} }}\n",
            ["0", "pi/2", "-pi/2"][k % 3]
        );
        links += "  - { M: 1, MS: [0.1, 0.02, 0.03], I: [0.1, 0.12, 0.09, 0, 0, 0] }\n";
    }
    format!("name: six-laws\nconvention: modified\njoints:\n{joints}links:\n{links}")
}

fn state(random: &mut Random) -> At {
    let mut numbers = |size: f64| -> Vec<f64> { (0..6).map(|_| random.within(-size, size)).collect() };
    let (q, dq, ddq) = (numbers(3.0), numbers(2.0), numbers(5.0));
    let temp = numbers(20.0).iter().map(|x| 30.0 + x).collect();
    At { q, dq, ddq, temp, t: random.within(0.0, 60.0) }
}

/// The interpreter's torque is that of the arm without laws, and the walk's.
#[test]
fn the_law_adds_its_value() {
    for seed in 1..=8 {
        let robot = robot(&six(seed));
        let mut plain = robot.clone();
        plain.joints.iter_mut().for_each(|joint| joint.drive.law = None);
        let functions = [Function::InverseDynamics, Function::DriveTorques, Function::ClockedDriveTorques];
        let [with, without] = [&robot, &plain].map(|r| Interpreter::new(&Model::with_effects(r), &functions));
        let phi = param::standard_values(&robot.effective()).unwrap();
        let mut random = Random(seed + 100);
        for _ in 0..20 {
            let at = state(&mut random);
            let truly = At {
                q: at.q.iter().map(|q| q + 0.01).collect(),
                dq: at.dq.clone(),
                ddq: at.ddq.clone(),
                temp: at.temp.clone(),
                t: at.t,
            };
            let warmth = [1.0; 6];
            let drives: Vec<f64> =
                [&phi[..], &[0.0; 6], &warmth, &[at.t], &at.temp].into_iter().flatten().copied().collect();
            let run = |interpreter: &Interpreter, function, parameters: &[f64]| {
                interpreter.one(function, &State { q: &at.q, dq: &at.dq, ddq: &at.ddq, tau: &[], parameters })
            };
            let clocked = Function::ClockedDriveTorques;
            let (a, b) = (run(&with, clocked, &drives), run(&without, clocked, &drives));
            // Without a clock the motion has just begun, at the temperature of the room.
            let still = Function::InverseDynamics;
            let (c, d) = (run(&with, still, &phi), run(&without, still, &phi));
            let begun = At {
                temp: vec![25.0; 6],
                t: 0.0,
                ..At { q: truly.q.clone(), dq: at.dq.clone(), ddq: at.ddq.clone(), temp: vec![], t: 0.0 }
            };
            for k in 0..6 {
                let term = law(&robot, k).term();
                for (found, expected) in [(a[k] - b[k], value(term, &truly)), (c[k] - d[k], value(term, &begun))] {
                    assert!((found - expected).abs() < 1e-9 * (1.0 + expected.abs()), "{term}: {found} {expected}");
                }
            }
        }
    }
}

/// Derivatives of the torques by the tape, against central differences.
#[test]
fn gradients() {
    let laws = two(
        ", law: \"0.7*sin(3*q1)*tanh(dq1/0.5) + 0.2*ddq1*q1^3/(1 + q1^2)\", unit: N m",
        ", law: \"3*exp(-abs(dq2)/0.3)*sign(dq2) + 0.4*ln(1 + (q2/0.5)^2) + max(2*q1, 0.1)*abs(dq1)^1.5\", unit: N",
    );
    let robot = robot(&laws);
    let interpreter =
        Interpreter::new(&Model::with_effects(&robot), &[Function::InverseDynamics, Function::InverseDynamicsAdjoint]);
    let phi = param::standard_values(&robot.effective()).unwrap();
    let (q, dq, ddq) = ([0.4, -0.3], [0.6, -0.2], [1.0, -2.0]);
    let seeds = [0.8, -1.3];
    let with_seeds: Vec<f64> = phi.iter().chain(&seeds).copied().collect();
    let found = interpreter
        .one(Function::InverseDynamicsAdjoint, &State { q: &q, dq: &dq, ddq: &ddq, tau: &[], parameters: &with_seeds });
    for which in 0..3 {
        for k in 0..2 {
            let sum = |by: f64| {
                let mut state = [q, dq, ddq];
                state[which][k] += by;
                let [q, dq, ddq] = &state;
                let tau = interpreter.one(Function::InverseDynamics, &State { q, dq, ddq, tau: &[], parameters: &phi });
                tau.iter().zip(seeds).map(|(t, s)| t * s).sum::<f64>()
            };
            let expected = (sum(1e-6) - sum(-1e-6)) / 2e-6;
            let found = found[2 * which + k];
            assert!((found - expected).abs() < 1e-7 * (1.0 + expected.abs()), "{which} {k}: {found} {expected}");
        }
    }
}

/// The crate of six random laws, compiled by itself: its own tests, and the interpreter's numbers to
/// the last bit, one by one, in packs, and along a motion.
#[test]
fn the_printed_crate_says_the_same_bits() {
    let text = six(3);
    let robot = robot(&text);
    let model = Model::with_effects(&robot);
    assert!(model.reads_clock());
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("six_laws");
    for (path, text) in dh_codegen::krate(&robot, &text) {
        let path = folder.join(path);
        std::fs::create_dir_all(path.parent().unwrap()).unwrap();
        std::fs::write(path, text).unwrap();
    }
    let functions = [Function::InverseDynamics, Function::DriveTorques, Function::ClockedDriveTorques];
    let interpreter = Interpreter::new(&model, &functions);
    let phi = param::standard_values(&robot.effective()).unwrap();
    let mut random = Random(5);
    let mut rows = String::new();
    for _ in 0..50 {
        let at = state(&mut random);
        let bristle: Vec<f64> = (0..6).map(|_| random.within(-1.0, 1.0)).collect();
        let warmth: Vec<f64> = (0..6).map(|_| random.within(0.5, 1.5)).collect();
        let clock: Vec<f64> = [at.t].into_iter().chain(at.temp.iter().copied()).collect();
        let run = |function, more: &[&[f64]]| -> Vec<u64> {
            let parameters: Vec<f64> = phi.iter().chain(more.iter().copied().flatten()).copied().collect();
            let state = State { q: &at.q, dq: &at.dq, ddq: &at.ddq, tau: &[], parameters: &parameters };
            interpreter.one(function, &state).into_iter().map(f64::to_bits).collect()
        };
        rows += &format!(
            "    ([{:?}, {:?}, {:?}, {bristle:?}, {warmth:?}], {clock:?}, [{:?}, {:?}, {:?}]),\n",
            at.q,
            at.dq,
            at.ddq,
            run(functions[0], &[]),
            run(functions[1], &[&bristle, &warmth]),
            run(functions[2], &[&bristle, &warmth, &clock]),
        );
    }
    let test = format!(
        "use six_laws::runtime::Pack;
use six_laws::*;

const ROWS: [([[f64; 6]; 5], [f64; 7], [[u64; 6]; 3]); 50] = [
{rows}];

#[test]
fn bits() {{
    let phi = STANDARD_VALUES.unwrap();
    for ([q, dq, ddq, bristle, warmth], clock, [still, drives, clocked]) in &ROWS {{
        assert_eq!(inverse_dynamics(q, dq, ddq, &phi).map(f64::to_bits), *still);
        assert_eq!(drive_torques(q, dq, ddq, &phi, bristle, warmth).map(f64::to_bits), *drives);
        let found = clocked_drive_torques(q, dq, ddq, &phi, bristle, warmth, clock);
        assert_eq!(found.map(f64::to_bits), *clocked);
        let pack = |x: &[f64; 6]| x.map(|x| Pack::new([x; 8]));
        let packed = inverse_dynamics(&pack(q), &pack(dq), &pack(ddq), &phi.map(|p| Pack::new([p; 8])));
        assert_eq!(packed.map(|p| p.to_array()[5].to_bits()), *still);
    }}
}}

/// Its clock goes by the steps, and starts at 0.
#[test]
fn a_drive_has_the_time() {{
    let phi = STANDARD_VALUES.unwrap();
    let ([q, dq, ddq, ..], clock, _) = &ROWS[0];
    let mut drive = Drive::new(q, dq);
    assert_eq!(drive.temperature, [25.0; 6]);
    // Two tapes: one has the time folded into it.
    let (with, without) = (drive.torques(dq, ddq, &phi), inverse_dynamics(q, dq, ddq, &phi));
    assert!(with.iter().zip(&without).all(|(a, b)| (a - b).abs() <= 1e-12 * (1.0 + b.abs())));
    drive.temperature.copy_from_slice(&clock[1..]);
    let found = drive.step(clock[0], q, dq, ddq, &phi);
    assert_eq!(found, clocked_drive_torques(q, dq, ddq, &phi, &drive.bristle, &[1.0; 6], clock));
}}
"
    );
    std::fs::create_dir_all(folder.join("tests")).unwrap();
    std::fs::write(folder.join("tests/bits.rs"), test).unwrap();
    let run = Command::new(env!("CARGO"))
        .args(["test", "--quiet", "--target-dir"])
        .arg(folder.join("target"))
        .current_dir(&folder)
        .env_remove("RUSTFLAGS")
        .output()
        .unwrap();
    let said = [run.stdout, run.stderr].map(|o| String::from_utf8_lossy(&o).into_owned()).concat();
    assert!(run.status.success(), "{said}");
    assert!(!said.contains("warning"), "{said}");
}
