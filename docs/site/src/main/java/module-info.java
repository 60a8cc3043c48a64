/** The documentation as a static site. */
module org.evoloop.site {
    requires org.commonmark;
    requires org.commonmark.ext.gfm.tables;
    requires static org.jspecify;
}
