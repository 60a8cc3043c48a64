/**
 * The command line for state machine models: shows, compares and checks them, generates projects, and reads converters'
 * journals.
 */
@SuppressWarnings("requires-automatic")
module org.evoloop.models {
    requires static org.jspecify;
    requires com.fasterxml.jackson.annotation;
    requires info.picocli;
    requires java.compiler;
    requires java.sql;
    requires java.xml;
    requires net.automatalib.api;
    requires net.automatalib.core;
    requires net.automatalib.modelchecker.m3c;
    requires org.eclipse.elk.alg.layered;
    requires org.eclipse.elk.core;
    requires org.eclipse.elk.graph;
    requires org.eclipse.emf.common;
    requires org.eclipse.emf.ecore;
    requires org.evoloop.check;
    requires org.evoloop.config;
    requires org.evoloop.console;
    requires org.evoloop.device;
    requires org.evoloop.journal;
    requires org.evoloop.learn;
    requires org.evoloop.page;
    requires org.evoloop.service;
    requires org.evoloop.svg;
    requires org.evoloop.xmi;
    requires tools.jackson.databind;

    opens org.evoloop.models to
            info.picocli;
    opens org.evoloop.models.device to
            info.picocli;
    opens org.evoloop.models.evolution to
            tools.jackson.databind;
    opens org.evoloop.models.format to
            tools.jackson.databind;
    opens org.evoloop.models.record to
            tools.jackson.databind;
}
