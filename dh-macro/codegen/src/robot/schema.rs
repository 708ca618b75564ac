//! Generates the JSON Schema of robot files for editors, from the tables that the checker uses.

use super::effects::{Description, EffectKey, EffectKind};
use super::keys::{self, JOINT, Key, ROBOT, Shape, Table};

/// Text of `robots/robot.schema.json`. Editors find it by the first line of each robot file.
pub fn schema() -> String {
    let mut root = vec![
        ("$schema", Json::Text("http://json-schema.org/draft-07/schema#".to_string())),
        ("title", Json::Text("Robot file of denavit".to_string())),
        ("description", Json::Text("SI units; every number may be an expression: L1 + 0.1, pi/2, 90deg".to_string())),
    ];
    root.extend(table(&ROBOT));
    let mut out = String::new();
    Json::Map(root).print(0, &mut out);
    out + "\n"
}

/// The subset of JSON that a schema needs.
enum Json {
    Text(String),
    Number(usize),
    Flag(bool),
    List(Vec<Json>),
    Map(Vec<(&'static str, Json)>),
}

impl Json {
    fn words(words: &[&str]) -> Self {
        Self::List(words.iter().map(|word| Self::Text((*word).to_string())).collect())
    }

    fn print(&self, indent: usize, out: &mut String) {
        match self {
            Self::Text(text) => *out += &format!("\"{}\"", text.replace('\\', "\\\\").replace('"', "\\\"")),
            Self::Number(number) => *out += &number.to_string(),
            Self::Flag(flag) => *out += &flag.to_string(),
            Self::List(items) => {
                *out += "[";
                for (k, item) in items.iter().enumerate() {
                    *out += if k > 0 { ", " } else { "" };
                    item.print(indent, out);
                }
                *out += "]";
            }
            Self::Map(fields) => {
                *out += "{";
                for (k, (key, value)) in fields.iter().enumerate() {
                    *out += &format!("{}\n{:width$}\"{key}\": ", if k > 0 { "," } else { "" }, "", width = indent + 2);
                    value.print(indent + 2, out);
                }
                *out += &format!("\n{:indent$}}}", "");
            }
        }
    }
}

fn kind(name: &str) -> (&'static str, Json) {
    ("type", Json::Text(name.to_string()))
}

/// Schema of a number, or of text with an expression.
fn number() -> Vec<(&'static str, Json)> {
    vec![("type", Json::words(&["number", "string"]))]
}

fn table(table: &'static Table) -> Vec<(&'static str, Json)> {
    let mut properties: Vec<(&'static str, Json)> = table.keys.iter().map(|key| (key.name, property(key))).collect();
    if table.effects {
        let named = |known: &&Description| table.key(known.name).is_none() && known.scope.at_joint();
        properties.extend(descriptions().filter(named).map(|known| (known.name, effect(known))));
    }
    let needed: Vec<&str> = table.keys.iter().filter(|key| key.required).map(|key| key.name).collect();
    vec![
        kind("object"),
        ("additionalProperties", Json::Flag(false)),
        ("required", Json::words(&needed)),
        ("properties", Json::Map(properties)),
    ]
}

fn descriptions() -> impl Iterator<Item = &'static Description> {
    EffectKind::ALL.iter().map(|kind| kind.description())
}

/// Schema of an effect: a number, or a mapping of its keys.
fn effect(known: &'static Description) -> Json {
    let described = |text: String| {
        let mut fields = vec![("description", Json::Text(text))];
        fields.extend(number());
        Json::Map(fields)
    };
    let words = |key: &EffectKey| match key.unit {
        "" => key.doc.to_string(),
        unit => format!("{} [{unit}]", key.doc),
    };
    let properties = known.keys.iter().map(|key| (key.name, described(words(key)))).collect();
    let mut map = vec![kind("object"), ("properties", Json::Map(properties))];
    if known.repeats == 1 {
        map.push(("additionalProperties", Json::Flag(false)));
    }
    let either = Json::List(vec![Json::Map(number()), Json::Map(map)]);
    Json::Map(vec![("description", Json::Text(format!("{}.", known.law))), ("anyOf", either)])
}

fn property(key: &'static Key) -> Json {
    let doc = if key.unit.is_empty() { key.doc.to_string() } else { format!("{} [{}]", key.doc, key.unit) };
    let mut fields = vec![("description", Json::Text(doc))];
    fields.extend(shape(&key.shape));
    Json::Map(fields)
}

fn items(count: usize) -> Vec<(&'static str, Json)> {
    let (least, most) = (("minItems", Json::Number(count)), ("maxItems", Json::Number(count)));
    vec![kind("array"), ("items", Json::Map(number())), least, most]
}

fn shape(shape: &Shape) -> Vec<(&'static str, Json)> {
    let with = |name, least| number().into_iter().chain([(name, Json::Number(least))]).collect();
    match *shape {
        Shape::Text => vec![kind("string")],
        Shape::Texts => vec![kind("array"), ("items", Json::Map(vec![kind("string")]))],
        Shape::Flag => vec![kind("boolean")],
        Shape::Choice(words) => vec![("enum", Json::words(words))],
        Shape::Count => vec![kind("integer"), ("minimum", Json::Number(0))],
        Shape::Number | Shape::Angle | Shape::Length => number(),
        Shape::Positive => with("exclusiveMinimum", 0),
        Shape::Vector(count) | Shape::Angles(count) => items(count),
        Shape::Constants => vec![kind("object"), ("additionalProperties", Json::Map(number()))],
        Shape::Numbers => {
            let list = Json::Map(vec![kind("array"), ("items", Json::Map(number()))]);
            vec![("anyOf", Json::List(vec![Json::Map(number()), list]))]
        }
        Shape::Columns(inner) => {
            let channel = Json::List(vec![Json::Map(vec![kind("string")]), Json::Map(table(inner))]);
            vec![kind("object"), ("additionalProperties", Json::Map(vec![("anyOf", channel)]))]
        }
        Shape::Map(inner) => table(inner),
        Shape::MapOrFile(inner) => {
            let file = Json::Map(vec![kind("string"), ("pattern", Json::Text("\\.ya?ml$".to_string()))]);
            vec![("anyOf", Json::List(vec![file, Json::Map(table(inner)), Json::Map(vec![kind("null")])]))]
        }
        Shape::Rows(inner) => {
            let least = usize::from(core::ptr::eq(inner, &JOINT));
            vec![kind("array"), ("items", Json::Map(table(inner))), ("minItems", Json::Number(least))]
        }
        Shape::RowsOrNull(inner) => {
            let row = Json::List(vec![Json::Map(table(inner)), Json::Map(vec![kind("null")])]);
            vec![("type", Json::words(&["array", "null"])), ("items", Json::Map(vec![("anyOf", row)]))]
        }
        Shape::Effects => {
            let whole = descriptions().filter(|known| known.scope.at_top());
            let mut properties: Vec<_> = whole.map(|known| (known.name, effect(known))).collect();
            properties.extend(keys::LAW_KEYS.iter().map(|key| (key.name, property(key))));
            vec![kind("object"), ("additionalProperties", Json::Flag(false)), ("properties", Json::Map(properties))]
        }
    }
}
