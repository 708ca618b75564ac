mod bands;
mod steps;
