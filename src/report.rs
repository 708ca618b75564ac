//! The only room that formats results.
