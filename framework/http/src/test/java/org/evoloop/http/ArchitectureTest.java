package org.evoloop.http;

import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;

import com.tngtech.archunit.core.importer.ImportOption;
import com.tngtech.archunit.junit.AnalyzeClasses;
import com.tngtech.archunit.junit.ArchTest;
import com.tngtech.archunit.lang.ArchRule;
import java.net.Socket;

/** Server and client do not depend on each other, and each is in one class. */
@AnalyzeClasses(packages = "org.evoloop.http", importOptions = ImportOption.DoNotIncludeTests.class)
class ArchitectureTest {
    @ArchTest
    static final ArchRule theServerIsInOnePlace = noClasses()
            .that()
            .haveNameNotMatching(".*\\.(RequestServer|RequestValues|RequestFaults|Door)(\\$.*)?")
            .should()
            .dependOnClassesThat()
            .resideInAnyPackage("com.sun.net.httpserver..");

    @ArchTest
    static final ArchRule theClientIsInOnePlace = noClasses()
            .that()
            .haveNameNotMatching(".*\\.(Caller|Limit)(\\$.*)?")
            .should()
            .dependOnClassesThat()
            .belongToAnyOf(Socket.class);
}
