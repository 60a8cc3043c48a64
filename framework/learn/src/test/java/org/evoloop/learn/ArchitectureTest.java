package org.evoloop.learn;

import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;

import com.tngtech.archunit.core.importer.ImportOption;
import com.tngtech.archunit.junit.AnalyzeClasses;
import com.tngtech.archunit.junit.ArchTest;
import com.tngtech.archunit.lang.ArchRule;

/** The answers are ours: the library that learns neither keeps them nor chooses when a device is pressed. */
@AnalyzeClasses(packages = "org.evoloop.learn", importOptions = ImportOption.DoNotIncludeTests.class)
class ArchitectureTest {
    @ArchTest
    static final ArchRule learnLibIsKnownInTwoPlaces = noClasses()
            .that()
            .haveNameNotMatching(".*\\.(Learning|Asking)(\\$.*)?")
            .should()
            .dependOnClassesThat()
            .resideInAPackage("de.learnlib..");

    @ArchTest
    static final ArchRule oneClassWritesFiles = noClasses()
            .that()
            .haveNameNotMatching(".*\\.AnswerLog(\\$.*)?")
            .should()
            .dependOnClassesThat()
            .resideInAnyPackage("java.io..", "java.nio.channels..");

    @ArchTest
    static final ArchRule timeIsTheClocks = noClasses()
            .should()
            .callMethod(System.class, "nanoTime")
            .orShould()
            .callMethod(System.class, "currentTimeMillis")
            .orShould()
            .callMethod(Thread.class, "sleep", long.class);
}
