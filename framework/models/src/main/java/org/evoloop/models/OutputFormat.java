package org.evoloop.models;

/** The formats of a command that can also draw its result. */
enum OutputFormat {
    TEXT,
    JSON,
    SVG
}
