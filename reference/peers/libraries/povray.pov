// SPDX-License-Identifier: MIT
// The scene that goes on for ever; what is open under these numbers povray.py has left it. trace()
// tells a point. A cylinder or cone below 1e-10 ends it ("Degenerate"): that is refused here.
#version 3.6;
#while (1)
  #fopen Ready "/proc/self/fd/100" write
  #fclose Ready
  #fopen Asked "/proc/self/fd/101" read
  #fopen Answers "/proc/self/fd/102" write
  #read (Asked, Count)
  #while (Count > 0)
    #read (Asked, Shape, Ox, Oy, Oz, Dx, Dy, Dz, A, B, C, D, E, F, G)
    #if ((Shape = 3 | Shape = 4) & F < 1e-10)
      #write (Answers, "invalid\n")
    #else
      #switch (Shape)
        #case (0) #declare S = plane { z, 0 }; #break
        #case (1) #declare S = disc { 0, z, G }; #break
        #case (2) #declare S = sphere { 0, D }; #break
        #case (3) #declare S = cylinder { 0, F * z, G }; #break
        #case (4) #declare S = cone { 0, G, F * z, 0 }; #break
        #case (5) #declare S = box { 0, <D, E, F> }; #break
      #end
      #declare N = 0 * x;
      #declare O = <Ox, Oy, Oz>;
      #declare T = vdot(trace(S, O, <Dx, Dy, Dz>, N) - O, <Dx, Dy, Dz>);
      #if (vlength(N) > 0)
        #write (Answers, "hit ", str(T, 0, 20), "\n")
      #else
        #write (Answers, "miss\n")
      #end
    #end
    #declare Count = Count - 1;
  #end
  #fclose Asked
  #fclose Answers
#end
