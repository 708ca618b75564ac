//! Settings from `compiler`, `option` and default classes.

use std::collections::BTreeMap;

use super::super::xml::{Element, Mistakes, children};

/// An attribute of an element or of a default of its class.
#[derive(Debug, Clone, Copy)]
pub(super) struct Value<'a> {
    /// Element that has the attribute.
    pub(super) at: Element<'a>,
    /// Name of the attribute.
    pub(super) name: &'static str,
    /// Text of its value.
    pub(super) text: &'a str,
}

/// Settings of the whole file.
pub(super) struct Settings<'a> {
    /// Unit of angle, rad.
    pub(super) angle: f64,
    /// Letters of `eulerseq`.
    pub(super) euler: &'a str,
    /// Whether shapes define the inertia even where it is given.
    pub(super) inertia_from_geoms: bool,
    /// Gravity, m/s^2.
    pub(super) gravity: [f64; 3],
    /// Skipped elements.
    pub(super) notes: Vec<String>,
    /// Default elements of each class: its own first, then those of the enclosing classes.
    classes: BTreeMap<&'a str, Vec<Element<'a>>>,
}

/// Names of attributes in use, as references that outlive a call.
const NAMES: [&str; 33] = [
    "type",
    "pos",
    "axis",
    "range",
    "limited",
    "actuatorfrcrange",
    "actuatorfrclimited",
    "ref",
    "damping",
    "frictionloss",
    "armature",
    "stiffness",
    "springref",
    "springdamper",
    "gear",
    "forcerange",
    "ctrlrange",
    "delay",
    "quat",
    "axisangle",
    "xyaxes",
    "zaxis",
    "euler",
    "size",
    "fromto",
    "mass",
    "density",
    "mesh",
    "shellinertia",
    "fitscale",
    "group",
    "material",
    "name",
];

impl<'a> Settings<'a> {
    pub(super) fn new(root: Element<'a>, found: &mut Mistakes) -> Self {
        let mut settings = Self {
            angle: 1f64.to_radians(),
            euler: "xyz",
            inertia_from_geoms: false,
            gravity: [0.0, 0.0, -9.81],
            notes: Vec::new(),
            classes: BTreeMap::from([("main", Vec::new())]),
        };
        for compiler in children(root, "compiler") {
            settings.compiler(compiler, found);
        }
        for option in children(root, "option") {
            if let Some(gravity) = found.numbers::<3>(option, "gravity") {
                settings.gravity = gravity;
            }
            for name in ["wind", "density", "viscosity"] {
                if found.list(option, name).is_some_and(|list| list.iter().any(|x| *x != 0.0)) {
                    settings.notes.push(format!("{name} of the air does not come along"));
                }
            }
        }
        for default in children(root, "default") {
            settings.default(default, &[], true);
        }
        settings.classes_exist(root, found);
        settings
    }

    /// Reports elements whose class is not among the defaults.
    fn classes_exist(&self, root: Element<'a>, found: &mut Mistakes) {
        let elements = root.descendants().filter(|n| n.is_element() && n.tag_name().name() != "default");
        for element in elements {
            let named = ["class", "childclass"].into_iter().filter_map(|name| element.attribute(name));
            for class in named.filter(|class| !self.classes.contains_key(class)) {
                found.element(element, format!("there is no default class `{class}`"), "correct the name, or add it");
            }
        }
    }

    fn compiler(&mut self, compiler: Element<'a>, found: &mut Mistakes) {
        match compiler.attribute("angle") {
            Some("radian") => self.angle = 1.0,
            Some("degree") => self.angle = 1f64.to_radians(),
            Some(other) => found.element(compiler, format!("`{other}` is no unit of angle"), "write degree or radian"),
            None => {}
        }
        if let Some(sequence) = compiler.attribute("eulerseq") {
            let known = sequence.len() == 3 && sequence.chars().all(|c| "xyzXYZ".contains(c));
            match known {
                true => self.euler = sequence,
                false => found.element(compiler, format!("`{sequence}` is no eulerseq"), "write three of x y z X Y Z"),
            }
        }
        self.inertia_from_geoms |= compiler.attribute("inertiafromgeom") == Some("true");
        if compiler.attribute("coordinate") == Some("global") {
            found.element(
                compiler,
                "global coordinates are not read",
                "let MuJoCo 2.3.3 or older save the model again",
            );
        }
        for name in ["balanceinertia", "boundmass", "boundinertia", "settotalmass", "inertiagrouprange"] {
            if let Some(value) = compiler.attribute(name).filter(|v| !["false", "0", "-1"].contains(v)) {
                self.notes.push(format!("compiler {name}=\"{value}\" is not applied"));
            }
        }
    }

    /// Adds a class with the defaults of its enclosing classes.
    fn default(&mut self, default: Element<'a>, around: &[Element<'a>], top: bool) {
        let name = default.attribute("class").unwrap_or("main");
        let mut elements: Vec<Element<'a>> = default.children().filter(|n| n.is_element()).collect();
        elements.extend(around);
        if top {
            // Several defaults at the top are combined.
            elements.extend(self.classes.get("main").into_iter().flatten());
            self.classes.insert("main", elements.clone());
        }
        self.classes.insert(name, elements.clone());
        for inner in children(default, "default") {
            self.default(inner, &elements, false);
        }
    }

    /// Value of an attribute of an element, or of its class.
    pub(super) fn value(&self, element: Element<'a>, tag: &str, class: Option<&str>, name: &str) -> Option<Value<'a>> {
        let name = NAMES.iter().find(|n| **n == name)?;
        let of = |at: Element<'a>| at.attribute(*name).map(|text| Value { at, name, text: text.trim() });
        let class = element.attribute("class").or(class).unwrap_or("main");
        let defaults = self.classes.get(class).or_else(|| self.classes.get("main"));
        let defaults = defaults.into_iter().flatten().filter(|n| n.tag_name().name() == tag);
        of(element).or_else(|| defaults.copied().find_map(of))
    }
}
