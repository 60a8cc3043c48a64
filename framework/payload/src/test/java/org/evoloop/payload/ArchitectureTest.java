package org.evoloop.payload;

import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;

import com.tngtech.archunit.core.importer.ImportOption;
import com.tngtech.archunit.junit.AnalyzeClasses;
import com.tngtech.archunit.junit.ArchTest;
import com.tngtech.archunit.lang.ArchRule;

/** Messages are only texts here, and one library reads JSON. */
@AnalyzeClasses(packages = "org.evoloop.payload", importOptions = ImportOption.DoNotIncludeTests.class)
class ArchitectureTest {
    @ArchTest
    static final ArchRule nothingIsReadOrWritten = noClasses()
            .should()
            .dependOnClassesThat()
            .resideInAnyPackage("java.io..", "java.net.http..", "java.nio.file..");

    @ArchTest
    static final ArchRule jacksonIsKnownInFourPlaces = noClasses()
            .that()
            .haveNameNotMatching(".*\\.(JsonObject|JsonRecord|Part|Template)(\\$.*)?")
            .should()
            .dependOnClassesThat()
            .resideInAPackage("tools.jackson..");
}
