package org.evoloop.homeassistant;

import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;

import com.tngtech.archunit.core.importer.ImportOption;
import com.tngtech.archunit.junit.AnalyzeClasses;
import com.tngtech.archunit.junit.ArchTest;
import com.tngtech.archunit.lang.ArchRule;

/** Which classes know how the connection is made. */
@AnalyzeClasses(packages = "org.evoloop.homeassistant", importOptions = ImportOption.DoNotIncludeTests.class)
class ArchitectureTest {
    @ArchTest
    static final ArchRule theWebSocketIsKnownInTwoPlaces = noClasses()
            .that()
            .haveNameNotMatching(".*\\.(HomeSession|HomeConnection|WebSocketServer)(\\$.*)?")
            .should()
            .dependOnClassesThat()
            .resideInAnyPackage("java.net.http..");
}
