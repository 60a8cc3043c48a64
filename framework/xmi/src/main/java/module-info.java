/** Reads state machines from model files, and flattens machines with composite states and regions. */
module org.evoloop.xmi {
    requires static org.jspecify;
    requires transitive org.evoloop.core;
    requires jakarta.xml.bind;
    requires java.xml;

    exports org.evoloop.statechart;
    exports org.evoloop.xmi;

    // The bindings of Astah's elements; the API opens the package further, to its implementation.
    opens org.evoloop.xmi.astah to
            jakarta.xml.bind;
}
