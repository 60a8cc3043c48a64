/**
 * The MAPE-K loop and the event converter: models, decisions, the deterministic core, new functions, and the
 * superclasses that a converter extends. The core itself is for the modules of the framework that record, replay and
 * check its inputs.
 */
@SuppressWarnings("module") // which modules there are is not known here
module org.evoloop.core {
    requires static org.jspecify;
    requires jdk.jfr;
    requires org.slf4j;

    exports org.evoloop.converter;
    exports org.evoloop.converter.edge;
    exports org.evoloop.engine to
            org.evoloop.check,
            org.evoloop.journal,
            org.evoloop.models;
    exports org.evoloop.engine.codec to
            org.evoloop.journal,
            org.evoloop.models,
            org.evoloop.page;
    exports org.evoloop.evolution;
    exports org.evoloop.function;
    exports org.evoloop.loop;
    exports org.evoloop.migration;
    exports org.evoloop.rehearsal;
    exports org.evoloop.statemachine;
    exports org.evoloop.time;

    uses org.evoloop.converter.ConverterDelegate.Maker;

    provides org.evoloop.converter.ConverterDelegate.Maker with
            org.evoloop.converter.changing.Delegates;
}
