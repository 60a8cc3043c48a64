/** Writes SVG pictures. */
module org.evoloop.svg {
    requires static org.jspecify;

    exports org.evoloop.svg;
}
