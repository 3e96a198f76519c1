// A sphere of radius 1 is asked along z, from distances at which the way to it is known.
#version 3.7;
global_settings { assumed_gamma 1 }
#declare Ball = sphere { 0, 1 }
#declare Normal = <0, 0, 0>;
#for (Power, -6, 8, 2)
    #declare Far = pow(10, Power);
    #declare Hit = trace(Ball, <0, 0, -1 - Far>, z, Normal);
    #debug concat("1e", str(Power, 0, 0), " away: expected a hit at z = -1, got ",
                  #if (vlength(Normal)) "one at ", str(Hit.z, 0, 0) #else "none" #end, "\n")
#end
